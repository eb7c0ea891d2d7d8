<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP" sourcelanguage="en">
<context>
    <name>tactooth::AimOverlay</name>
    <message>
        <source>Probe %1 mm</source>
        <translation>プローブ %1 mm</translation>
    </message>
    <message>
        <source>Sticks: %1 N to draw it out</source>
        <translation>刺さっています：抜くのに %1 N</translation>
    </message>
    <message>
        <source>Depth %1 of %2 mm</source>
        <translation>深さ %1 / %2 mm</translation>
    </message>
    <message>
        <source>Depth %1 mm</source>
        <translation>深さ %1 mm</translation>
    </message>
    <message>
        <source>Will touch the neighbour or gum</source>
        <translation>隣の歯または歯肉に触れます</translation>
    </message>
    <message>
        <source>Over the pulp %1 mm</source>
        <translation>歯髄まで %1 mm</translation>
    </message>
    <message>
        <source>In the pulp</source>
        <translation>歯髄の中</translation>
    </message>
    <message>
        <source>Force %1 N</source>
        <translation>力 %1 N</translation>
    </message>
</context>
<context>
    <name>tactooth::CavityFields</name>
    <message>
        <source>Cavity</source>
        <translation>窩洞</translation>
    </message>
    <message>
        <source>Decay</source>
        <translation>う蝕</translation>
    </message>
    <message>
        <source>Occlusal</source>
        <translation>咬合面</translation>
    </message>
    <message>
        <source>Buccal</source>
        <translation>頬側</translation>
    </message>
    <message>
        <source>Lingual</source>
        <translation>舌側</translation>
    </message>
    <message>
        <source>Mesial</source>
        <translation>近心</translation>
    </message>
    <message>
        <source>Distal</source>
        <translation>遠心</translation>
    </message>
    <message>
        <source>Seen from</source>
        <translation>見る向き</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深さ</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Taper of the walls</source>
        <translation>側壁の傾き</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How much the walls lean outward; 0: as the bur makes them</source>
        <translation>側壁が外へ開く角度。0 ならバーの形のとおり</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>窩底</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>平ら</translation>
    </message>
    <message>
        <source>Follows the surface</source>
        <translation>歯の表面に沿う</translation>
    </message>
    <message>
        <source>Mesial box</source>
        <translation>近心の隣接面窩洞</translation>
    </message>
    <message>
        <source>Distal box</source>
        <translation>遠心の隣接面窩洞</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Axial depth</source>
        <translation>軸側壁の深さ</translation>
    </message>
    <message>
        <source>Axial height</source>
        <translation>軸側壁の高さ</translation>
    </message>
    <message>
        <source>Choose Decay above, and click or drag over the tooth</source>
        <translation>上で「う蝕」を選び、歯の上をクリックまたはドラッグします</translation>
    </message>
    <message>
        <source>fits the width</source>
        <translation>幅に合わせる</translation>
    </message>
    <message>
        <source>Affected dentin</source>
        <translation>う蝕影響象牙質</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Leathery dentin around the decay: harder than the decay, softer than sound dentin</source>
        <translation>う蝕の周りの革様の象牙質。う蝕より硬く、健全な象牙質より軟らかい</translation>
    </message>
</context>
<context>
    <name>tactooth::DrillBar</name>
    <message>
        <source>Drill</source>
        <translation>ドリル</translation>
    </message>
    <message>
        <source>The bur in the handpiece</source>
        <translation>ハンドピースに付いているバー</translation>
    </message>
    <message>
        <source>What turns the bur</source>
        <translation>バーを回す駆動装置</translation>
    </message>
    <message>
        <source> Bur </source>
        <translation> バー </translation>
    </message>
    <message>
        <source>  Drive </source>
        <translation>  駆動 </translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>触診</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切削</translation>
    </message>
    <message>
        <source>Reset tooth</source>
        <translation>歯を元に戻す</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Touch (%1): the bur stands still and feels the tooth</source>
        <translation>触診（%1）：バーは止まったまま歯に触れます</translation>
    </message>
    <message>
        <source>Cut (%1): with the pedal down the bur turns and cuts</source>
        <translation>切削（%1）：ペダルを踏むとバーが回り、歯を削ります</translation>
    </message>
    <message>
        <source>Takes back the last cut or change (%1)</source>
        <translation>最後の切削や変更を取り消します（%1）</translation>
    </message>
    <message>
        <source>Does again what was taken back (%1)</source>
        <translation>取り消したことをもう一度行います（%1）</translation>
    </message>
    <message>
        <source>Puts back all that was cut (%1); Undo takes that back</source>
        <translation>削ったところをすべて元に戻します（%1）。「元に戻す」で取り消せます</translation>
    </message>
</context>
<context>
    <name>tactooth::EditorController</name>
    <message>
        <source>Edit a copy</source>
        <translation>写しを編集</translation>
    </message>
    <message>
        <source>Exercise to begin with:</source>
        <translation>もとにする課題：</translation>
    </message>
    <message>
        <source>An examination has begun: finish it before you make an exercise</source>
        <translation>試験中です。課題を作るのは試験を終えてからにしてください</translation>
    </message>
    <message>
        <source>New exercise</source>
        <translation>新しい課題</translation>
    </message>
    <message>
        <source>Preparing the tooth of the exercise…</source>
        <translation>課題の歯を準備しています…</translation>
    </message>
    <message>
        <source>The mouse draws the exercise on the tooth; right: turn, Ctrl and wheel: nearer</source>
        <translation>マウスで課題を歯に描きます。右ボタン：回す、Ctrl とホイール：近づける</translation>
    </message>
    <message>
        <source>Exercise editor</source>
        <translation>課題の編集</translation>
    </message>
    <message>
        <source>Click the next point, or the first one to close the line.</source>
        <translation>次の点をクリックします。最初の点をクリックすると線が閉じます。</translation>
    </message>
    <message>
        <source>Click or drag: paint decay. Right click: take it away.</source>
        <translation>クリックまたはドラッグ：う蝕を描く。右クリック：取り除く。</translation>
    </message>
    <message>
        <source>Click: add a point. Drag: move it. Right click: remove it.</source>
        <translation>クリック：点を加える。ドラッグ：動かす。右クリック：消す。</translation>
    </message>
    <message>
        <source>Save exercise</source>
        <translation>課題を保存</translation>
    </message>
    <message>
        <source>Exercises (*.toml)</source>
        <translation>課題 (*.toml)</translation>
    </message>
    <message>
        <source>The exercise was saved to %1</source>
        <translation>課題を %1 に保存しました</translation>
    </message>
    <message>
        <source>Unsaved exercise</source>
        <translation>保存していない課題</translation>
    </message>
    <message>
        <source>The exercise has changes that are not saved. Save it first?</source>
        <translation>課題に保存していない変更があります。先に保存しますか？</translation>
    </message>
</context>
<context>
    <name>tactooth::EditorPanel</name>
    <message>
        <source>Undo</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Takes the last change back</source>
        <translation>直前の変更を取り消します</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>Makes it again</source>
        <translation>取り消した変更をもう一度行います</translation>
    </message>
    <message>
        <source>Try it</source>
        <translation>試す</translation>
    </message>
    <message>
        <source>Starts the exercise as a student sees it</source>
        <translation>学生と同じ見え方で課題を始めます</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Writes the file of the exercise, and adds it to your own</source>
        <translation>課題をファイルに書き、自作の課題に加えます</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Leaves the editor; asks first if changes are not saved</source>
        <translation>編集を終えます。保存していない変更があれば確かめます</translation>
    </message>
    <message>
        <source>You are trying the exercise as a student sees it. Nothing of what you cut is kept.</source>
        <translation>学生と同じ見え方で課題を試しています。削ったものは残りません。</translation>
    </message>
    <message>
        <source>Back to the editor</source>
        <translation>編集に戻る</translation>
    </message>
    <message>
        <source>The exercise is as you left it</source>
        <translation>課題は元のままです</translation>
    </message>
    <message>
        <source>The exercise is complete.</source>
        <translation>課題はそろっています。</translation>
    </message>
</context>
<context>
    <name>tactooth::IdealBox</name>
    <message>
        <source>Ideal cavity</source>
        <translation>理想窩洞</translation>
    </message>
    <message>
        <source>Show the ideal</source>
        <translation>理想窩洞を表示</translation>
    </message>
    <message>
        <source>The cavity that the outline, the fields and the bur make now, as blue glass in the tooth, darker the deeper it lies, as the student sees it</source>
        <translation>今の外形、欄の数値、バーからできる窩洞を、学生に見えるのと同じ青いガラスとして歯の中に示します。深いほど濃くなります</translation>
    </message>
    <message>
        <source>There is no ideal cavity yet.</source>
        <translation>理想窩洞はまだありません。</translation>
    </message>
    <message>
        <source>The ideal cavity is being prepared… %1 %</source>
        <translation>理想窩洞を準備しています… %1 %</translation>
    </message>
    <message>
        <source>This tooth has no pulp.</source>
        <translation>この歯には歯髄がありません。</translation>
    </message>
    <message>
        <source>The ideal cavity opens the pulp.</source>
        <translation>理想窩洞では露髄します。</translation>
    </message>
    <message>
        <source>Least remaining dentin over the pulp: %1 mm</source>
        <translation>歯髄までの残存象牙質：最小 %1 mm</translation>
    </message>
    <message>
        <source>Only %1 mm of dentin remains over the pulp: less than %2 mm barely shields it.</source>
        <translation>歯髄までの残存象牙質が %1 mm しかありません。%2 mm 未満では歯髄をほとんど守れません。</translation>
    </message>
</context>
<context>
    <name>tactooth::ExerciseMenu</name>
    <message>
        <source>E&amp;xercise</source>
        <translation>課題(&amp;X)</translation>
    </message>
    <message>
        <source>C&amp;hoose an exercise…</source>
        <translation>課題を選ぶ(&amp;H)…</translation>
    </message>
    <message>
        <source>&amp;New exercise…</source>
        <translation>新しい課題(&amp;N)…</translation>
    </message>
    <message>
        <source>Edit a &amp;copy…</source>
        <translation>写しを編集(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Your own</source>
        <translation>自作の課題(&amp;Y)</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>まだありません</translation>
    </message>
</context>
<context>
    <name>tactooth::ReplayBar</name>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>再生</translation>
    </message>
    <message>
        <source>Plays or pauses the recording</source>
        <translation>記録を再生・一時停止します</translation>
    </message>
    <message>
        <source>To the event or comment before</source>
        <translation>前の出来事かコメントへ</translation>
    </message>
    <message>
        <source>Back by one tick</source>
        <translation>1 ティック戻る</translation>
    </message>
    <message>
        <source>On by one tick</source>
        <translation>1 ティック進む</translation>
    </message>
    <message>
        <source>To the next event or comment</source>
        <translation>次の出来事かコメントへ</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>比較…</translation>
    </message>
    <message>
        <source>Opens another recording to compare with, or closes it</source>
        <translation>比較する別の記録を開くか、閉じます</translation>
    </message>
    <message>
        <source>&amp;begins later by</source>
        <translation>開始を遅らせる(&amp;B)</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>How much later the other recording begins on the time line; negative: earlier</source>
        <translation>もう一方の記録を時間の線の上でどれだけ遅く始めるか（負の値なら早く）</translation>
    </message>
    <message>
        <source>At the first touch</source>
        <translation>最初の接触に合わせる</translation>
    </message>
    <message>
        <source>Shifts the other recording so that both touch the tooth first at the same moment</source>
        <translation>2つの記録で最初に歯に触れる瞬間がそろうように、もう一方の記録をずらします</translation>
    </message>
    <message>
        <source>Other recording: %1</source>
        <translation>もう一方の記録：%1</translation>
    </message>
    <message>
        <source>Leave replay</source>
        <translation>再生を終える</translation>
    </message>
    <message>
        <source>Back to the tooth as it was</source>
        <translation>元の歯に戻ります</translation>
    </message>
    <message>
        <source>Speed of the replay</source>
        <translation>再生の速さ</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 倍</translation>
    </message>
    <message>
        <source>Comment…</source>
        <translation>コメント…</translation>
    </message>
    <message>
        <source>Pins a comment to this moment</source>
        <translation>この瞬間にコメントを付けます</translation>
    </message>
</context>
<context>
    <name>tactooth::ReplaySlider</name>
    <message>
        <source>Time of the recording</source>
        <translation>記録の時刻</translation>
    </message>
    <message>
        <source>Time of the recording; the marks are events and comments</source>
        <translation>記録の時刻。目印は出来事とコメントです</translation>
    </message>
</context>
<context>
    <name>tactooth::ReplayPanel</name>
    <message>
        <source>Replay</source>
        <translation>再生中</translation>
    </message>
    <message>
        <source>Nothing can be cut here. The tooth on the bench waits unchanged.</source>
        <translation>ここでは削れません。作業中の歯はそのまま残っています。</translation>
    </message>
</context>
<context>
    <name>tactooth::ReplayCommentMenu</name>
    <message>
        <source>The comments on this recording cannot be read, so none can be added.</source>
        <translation>この記録のコメントを読めないため、追加できません。</translation>
    </message>
    <message>
        <source>Comment</source>
        <translation>コメント</translation>
    </message>
    <message>
        <source>Comment at %1 s:</source>
        <translation>%1 秒のコメント：</translation>
    </message>
    <message>
        <source>No comments yet</source>
        <translation>コメントはまだありません</translation>
    </message>
    <message>
        <source>Remove the comment here</source>
        <translation>ここのコメントを消す</translation>
    </message>
</context>
<context>
    <name>tactooth::ReplayController</name>
    <message>
        <source>Open recording</source>
        <translation>記録を開く</translation>
    </message>
    <message>
        <source>Recorded sessions (*.ttsession);;All files (*)</source>
        <translation>セッションの記録 (*.ttsession);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Opening recording %1…</source>
        <translation>記録 %1 を開いています…</translation>
    </message>
    <message>
        <source>Replay: Space plays and pauses, Escape leads back to the tooth.</source>
        <translation>再生中：スペースで再生・一時停止、Esc で元の歯に戻ります。</translation>
    </message>
    <message>
        <source>The tooth is as you left it.</source>
        <translation>歯は元のままです。</translation>
    </message>
    <message>
        <source>This program differs from the one that made the recording: from %1 s on the replay is not what happened.</source>
        <translation>このプログラムは記録したときのものと異なります。%1 秒から後の再生は、実際に起きたこととは違います。</translation>
    </message>
    <message>
        <source>Recordings can be opened when the examination is over</source>
        <translation>記録は試験が終わってから開けます</translation>
    </message>
</context>
<context>
    <name>tactooth::ReplayComparison</name>
    <message>
        <source>S&amp;ide by side…</source>
        <translation>並べて比較(&amp;I)…</translation>
    </message>
    <message>
        <source>Side by side…</source>
        <translation>並べて比較…</translation>
    </message>
    <message>
        <source>Shows another recording in a picture of its own beside this one; once more, and it is as before (%1)</source>
        <translation>別の記録を、この記録の隣の画面に表示します。もう一度押すと元に戻ります（%1）</translation>
    </message>
    <message>
        <source>Shows another recording beside this one, or no longer</source>
        <translation>別の記録をこの記録の隣に表示する、またはやめる</translation>
    </message>
    <message>
        <source>Compare with another recording</source>
        <translation>別の記録と比較</translation>
    </message>
    <message>
        <source>Recorded sessions (*.ttsession);;All files (*)</source>
        <translation>セッションの記録 (*.ttsession);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>A recording has no touch: both begin at the same moment.</source>
        <translation>歯に触れていない記録があるため、2つの記録を同時に始めます。</translation>
    </message>
    <message>
        <source>Both recordings touch the tooth first at the same moment.</source>
        <translation>2つの記録は、最初に歯に触れる瞬間がそろっています。</translation>
    </message>
</context>
<context>
    <name>tactooth::ReplayPicture</name>
    <message>
        <source>The colour of this recording in the plots</source>
        <translation>グラフでのこの記録の色</translation>
    </message>
    <message>
        <source>Closes this recording; the other one stays</source>
        <translation>この記録を閉じます。もう一方は残ります</translation>
    </message>
</context>
<context>
    <name>tactooth::DrivePanel</name>
    <message>
        <source>Bur speed</source>
        <translation>バーの回転数</translation>
    </message>
    <message>
        <source>× 1000 rev/min</source>
        <translation>× 1000 回転/分</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Keep down</source>
        <translation>踏んだまま</translation>
    </message>
    <message>
        <source>Pedal</source>
        <translation>ペダル</translation>
    </message>
    <message>
        <source>The foot pedal. Let go and it springs back; the space key presses it fully.</source>
        <translation>フットペダル。放すと戻ります。スペースキーでいっぱいに踏めます。</translation>
    </message>
    <message>
        <source>The pedal stays where it is, so that the hand is free for the bur.</source>
        <translation>ペダルがその位置に留まり、手をバーの操作に使えます。</translation>
    </message>
</context>
<context>
    <name>tactooth::ForcePanel</name>
    <message>
        <source>Mouse cuts to a depth</source>
        <translation>マウスは決めた深さまで削る</translation>
    </message>
    <message>
        <source>Mouse presses by force</source>
        <translation>マウスは力で押す</translation>
    </message>
    <message>
        <source>How the mouse presses</source>
        <translation>マウスの押し方</translation>
    </message>
    <message>
        <source>To a depth: the bur stops at the depth that is set here.
By force: the bur sinks for as long as the button is down.</source>
        <translation>深さまで：バーはここで決めた深さで止まります。
力で：ボタンを押している間、バーは沈み続けます。</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深さ</translation>
    </message>
    <message>
        <source>Depth of the tip below the uncut surface at which the bur stops.
The mouse wheel in the picture changes it by 0.1 mm, with Shift by 0.02 mm.</source>
        <translation>バーが止まる深さ（削る前の表面から先端まで）。
画面上のマウスホイールで0.1 mm、Shiftと一緒に0.02 mmずつ変わります。</translation>
    </message>
    <message>
        <source>Flat floor</source>
        <translation>平らな窩底</translation>
    </message>
    <message>
        <source>On: the depth counts from the place where the cavity was begun, and the floor is flat.
Off: the floor follows the surface.</source>
        <translation>オン：深さは削り始めた場所から数え、窩底は平らになります。
オフ：窩底は表面に沿います。</translation>
    </message>
    <message>
        <source>How far the mouse presses beyond the surface: 1 mm is about 1 N on enamel.</source>
        <translation>マウスが表面より先へ押す距離：エナメル質では1 mmがおよそ1 Nです。</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>摩擦</translation>
    </message>
    <message>
        <source>Force against sliding, as a share of the force into the tooth</source>
        <translation>滑りに逆らう力（歯に押す力に対する割合）</translation>
    </message>
    <message>
        <source>Feel like</source>
        <translation>感触</translation>
    </message>
    <message>
        <source>Lets the whole tooth feel like one tissue: fills in its spring, damper and friction</source>
        <translation>歯全体を一つの組織の感触にします：そのばね、ダンパー、摩擦を入れます</translation>
    </message>
    <message>
        <source>Feel like…</source>
        <translation>感触を選ぶ…</translation>
    </message>
    <message>
        <source>From the material</source>
        <translation>材質に合わせる</translation>
    </message>
    <message>
        <source>Spring, damper and friction are those of the tissue under the bur:
enamel is hard, dentin softer, caries soft. Switch off to set them yourself.</source>
        <translation>ばね、減衰、摩擦はバーの下の組織の値です：
エナメル質は硬く、象牙質はやや軟らかく、う蝕は軟らかい。自分で決めるにはオフにします。</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>ばね</translation>
    </message>
    <message>
        <source> N/mm</source>
        <translation> N/mm</translation>
    </message>
    <message>
        <source>How hard the tooth feels: force for each millimetre pressed in</source>
        <translation>歯の硬さ：1 mm 押し込むごとの力</translation>
    </message>
    <message>
        <source>Damper</source>
        <translation>減衰</translation>
    </message>
    <message>
        <source> N·s/mm</source>
        <translation> N·s/mm</translation>
    </message>
    <message>
        <source>Force against moving into the tooth, for each mm/s</source>
        <translation>歯に入る動きに逆らう力（1 mm/s ごと）</translation>
    </message>
    <message>
        <source>Force scale</source>
        <translation>力の倍率</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> 倍</translation>
    </message>
    <message>
        <source>Multiplies the whole force</source>
        <translation>力全体に掛ける倍率</translation>
    </message>
    <message>
        <source>Mouse presses</source>
        <translation>マウスの押し込み</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>初期値</translation>
    </message>
    <message>
        <source>Device stops there</source>
        <translation>装置も止める</translation>
    </message>
    <message>
        <source>A device that renders force holds the bur at the depth and pushes the hand back.
It is off in an examination.</source>
        <translation>力覚のある装置では、バーをその深さで止め、手を押し返します。
試験中は使えません。</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>誘導</translation>
    </message>
    <message>
        <source>A device that renders force gently pushes the hand back where the bur goes beyond the walls of the target.
It can be overcome, and is off in an examination.</source>
        <translation>力覚のある装置では、バーが目標の窩壁を越えると、手を穏やかに押し戻します。
力を入れれば越えられます。試験中は使えません。</translation>
    </message>
</context>
<context>
    <name>tactooth::GuidedTour</name>
    <message>
        <source>Demonstration: the bur hovers where the mouse points</source>
        <translation>デモ：マウスが指すところにバーが浮きます</translation>
    </message>
    <message>
        <source>Left button: the bur presses; the gauge shows the force</source>
        <translation>左ボタン：バーが押します。力は計器に出ます</translation>
    </message>
    <message>
        <source>Button up: the bur lifts</source>
        <translation>ボタンを放す：バーが離れます</translation>
    </message>
    <message>
        <source>Button up, pedal up</source>
        <translation>ボタンとペダルを放します</translation>
    </message>
    <message>
        <source>Cut and the pedal: the bur turns and removes what it presses on</source>
        <translation>切削とペダル：バーが回り、押したところを削ります</translation>
    </message>
    <message>
        <source>Undo takes the cut back. Now it is your turn</source>
        <translation>「元に戻す」で切削を取り消します。次はあなたの番です</translation>
    </message>
</context>
<context>
    <name>tactooth::InspectionPanel</name>
    <message>
        <source>Tolerance</source>
        <translation>許容差</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Tolerance: a smaller distance to the target is shown white</source>
        <translation>許容差：目標との差がこれより小さい所は白で示します</translation>
    </message>
    <message>
        <source>Where the section runs: from the far to the near side</source>
        <translation>断面の位置：奥側から手前側まで</translation>
    </message>
    <message>
        <source>Look through the enamel at the dentin and the caries in it</source>
        <translation>エナメル質を透かして象牙質とう蝕を見ます</translation>
    </message>
    <message>
        <source>Look through the dentin at the pulp</source>
        <translation>象牙質を透かして歯髄を見ます</translation>
    </message>
    <message>
        <source>Target…</source>
        <translation>目標…</translation>
    </message>
    <message>
        <source>Show distance</source>
        <translation>距離を表示</translation>
    </message>
    <message>
        <source>Show what to cut</source>
        <translation>削る所を表示</translation>
    </message>
    <message>
        <source>What to &amp;cut: ghost of the target</source>
        <translation>削る所：目標の透視表示(&amp;C)</translation>
    </message>
    <message>
        <source>The cavity of the target as blue glass in the tooth, darker the deeper it lies, with a dark line around its opening. Each wall disappears where you have cut as far as it.</source>
        <translation>目標の窩洞を歯の中に青いガラスとして表示します。深いほど濃く、開口部は濃い線で囲まれます。壁は、そこまで削ると消えます。</translation>
    </message>
    <message>
        <source>This target has no cavity in the tooth: nothing of it lies inside</source>
        <translation>この目標には歯の中に窩洞がありません（内側にある部分がありません）</translation>
    </message>
    <message>
        <source>Choose a target first: the tooth with the ideal cavity</source>
        <translation>先に目標（理想窩洞の歯）を選んでください</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Occlusal</source>
        <translation>咬合面</translation>
    </message>
    <message>
        <source>Buccal</source>
        <translation>頬側</translation>
    </message>
    <message>
        <source>Lingual</source>
        <translation>舌側</translation>
    </message>
    <message>
        <source>Mesial</source>
        <translation>近心</translation>
    </message>
    <message>
        <source>Distal</source>
        <translation>遠心</translation>
    </message>
    <message>
        <source>At the bur</source>
        <translation>バーの位置</translation>
    </message>
    <message>
        <source>The section goes with the tip of the bur, so that its floor and walls are seen as they are cut</source>
        <translation>断面がバーの先端とともに動き、窩底と窩壁を削りながら見られます</translation>
    </message>
    <message>
        <source>Takes this side of the tooth out of the picture; the tooth itself stays whole</source>
        <translation>歯のこの側を表示から取り除きます。歯そのものは変わりません</translation>
    </message>
    <message>
        <source>One eye</source>
        <translation>単眼</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>左右並べ</translation>
    </message>
    <message>
        <source>Red and cyan</source>
        <translation>赤青メガネ</translation>
    </message>
    <message>
        <source>Shows depth: side by side for goggles, red and cyan for coloured glasses</source>
        <translation>立体表示：左右並べはゴーグル用、赤青は色メガネ用</translation>
    </message>
    <message>
        <source>An STL file of the ideal shape, in the frame of the tooth</source>
        <translation>理想形の STL ファイル（歯と同じ座標系）</translation>
    </message>
    <message>
        <source>Blue: still to cut. White: as the target. Orange: cut too deep. Strongest at 0.5 mm.</source>
        <translation>青：削り残し。白：目標どおり。橙：削りすぎ。0.5 mm で最も濃くなります。</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Enamel</source>
        <translation>エナメル質</translation>
    </message>
    <message>
        <source>Dentin</source>
        <translation>象牙質</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>立体視</translation>
    </message>
</context>
<context>
    <name>tactooth::MainWindow</name>
    <message>
        <source>The usual values take their places.</source>
        <translation>代わりに既定の値を使います。</translation>
    </message>
    <message>
        <source>The window starts with its defaults; the file is kept as %1.</source>
        <translation>ウィンドウは初期設定で始まります。ファイルは %1 として残しました。</translation>
    </message>
    <message>
        <source>The window starts with its defaults.</source>
        <translation>ウィンドウは初期設定で始まります。</translation>
    </message>
    <message>
        <source>Tactooth</source>
        <translation>Tactooth</translation>
    </message>
    <message>
        <source>Preparing the tooth…</source>
        <translation>歯を準備しています…</translation>
    </message>
    <message>
        <source>This tooth brings its own materials: it may feel harder, softer or rougher than others</source>
        <translation>この歯には独自の材料が含まれています。ほかの歯より硬く、柔らかく、またはざらついて感じられることがあります</translation>
    </message>
    <message>
        <source>%1[*] — Tactooth</source>
        <translation>%1[*] — Tactooth</translation>
    </message>
    <message>
        <source>Writing a file</source>
        <translation>ファイルの書き込み</translation>
    </message>
    <message>
        <source>No file is written or changed</source>
        <translation>ファイルは作られず、変更もされません</translation>
    </message>
    <message>
        <source>A file is being written: the window closes as soon as it is complete</source>
        <translation>ファイルを書き込んでいます。書き終わるとウィンドウを閉じます</translation>
    </message>
</context>
<context>
    <name>tactooth::AppearanceMenu</name>
    <message>
        <source>&amp;Dark colours</source>
        <translation>暗い配色(&amp;D)</translation>
    </message>
    <message>
        <source>Te&amp;xt size</source>
        <translation>文字の大きさ(&amp;X)</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>言語(&amp;L)</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>システムに従う</translation>
    </message>
</context>
<context>
    <name>tactooth::DeviceController</name>
    <message>
        <source>Press the pedal fully, then let it go</source>
        <translation>ペダルをいっぱいに踏んでから離してください</translation>
    </message>
    <message>
        <source>Opening the device…</source>
        <translation>装置を開いています…</translation>
    </message>
    <message>
        <source>The pedal is %1</source>
        <translation>ペダルは %1 です</translation>
    </message>
</context>
<context>
    <name>tactooth::DockLayout</name>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>View</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Drill</source>
        <translation>ドリル</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>音</translation>
    </message>
    <message>
        <source>Look inside</source>
        <translation>内部を見る</translation>
    </message>
    <message>
        <source>Last ten seconds</source>
        <translation>直近の10秒</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>できごと</translation>
    </message>
    <message>
        <source>Real time</source>
        <translation>リアルタイム</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
</context>
<context>
    <name>tactooth::ExerciseController</name>
    <message>
        <source>Preparing the exercise: %1…</source>
        <translation>課題を準備中：%1…</translation>
    </message>
    <message>
        <source>Preparing the target of %1…</source>
        <translation>%1 の目標を準備しています…</translation>
    </message>
    <message>
        <source>Measuring the distance to %1…</source>
        <translation>%1 までの距離を測っています…</translation>
    </message>
    <message>
        <source>Blue: still to cut. White: as the target. Orange: cut too deep. Strongest at 0.5 mm.</source>
        <translation>青：削り残し。白：目標どおり。橙：削りすぎ。0.5 mm で最も濃くなります。</translation>
    </message>
    <message>
        <source>Target: the ideal shape, in the frame of the tooth</source>
        <translation>目標：理想形（歯と同じ座標系）</translation>
    </message>
    <message>
        <source>Surfaces and saved teeth (*.stl *.STL *.obj *.ply *.tactooth);;All files (*)</source>
        <translation>表面と保存した歯 (*.stl *.STL *.obj *.ply *.tactooth);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Open exercise</source>
        <translation>課題を開く</translation>
    </message>
    <message>
        <source>Exercises (*.toml);;All files (*)</source>
        <translation>課題 (*.toml);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Report of what was done</source>
        <translation>練習の報告書</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>The report was written to %1</source>
        <translation>報告書を %1 に書き出しました</translation>
    </message>
    <message>
        <source>Preparing the target</source>
        <translation>目標の準備</translation>
    </message>
    <message>
        <source>The tooth and the target stay as they are</source>
        <translation>歯と目標は今のままです</translation>
    </message>
    <message>
        <source>It was cancelled: the target before stays</source>
        <translation>取り消しました。前の目標がそのまま残ります</translation>
    </message>
    <message>
        <source>It was cancelled: there is no target</source>
        <translation>取り消しました。目標はありません</translation>
    </message>
</context>
<context>
    <name>tactooth::FileMenu</name>
    <message>
        <source>Open recor&amp;ding…</source>
        <translation>記録を開く(&amp;D)…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Open tooth…</source>
        <translation>歯を開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Built-in teeth</source>
        <translation>内蔵の歯(&amp;B)</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近使った歯(&amp;R)</translation>
    </message>
    <message>
        <source>Tooth of the &amp;case</source>
        <translation>症例の歯(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Import scan…</source>
        <translation>スキャンの取り込み(&amp;I)…</translation>
    </message>
    <message>
        <source>Open &amp;bur…</source>
        <translation>バーを開く(&amp;B)…</translation>
    </message>
    <message>
        <source>Open e&amp;xercise…</source>
        <translation>課題を開く(&amp;X)…</translation>
    </message>
    <message>
        <source>&amp;Save tooth…</source>
        <translation>歯を保存(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Export cut tooth…</source>
        <translation>削った歯を書き出す(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Import %1…</source>
        <translation>%1 の取り込み…</translation>
    </message>
    <message>
        <source>Import a &amp;folder of scans…</source>
        <translation>スキャンのフォルダーの取り込み(&amp;F)…</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>キー(&amp;K)…</translation>
    </message>
    <message>
        <source>Se&amp;ttings…</source>
        <translation>設定(&amp;T)…</translation>
    </message>
</context>
<context>
    <name>tactooth::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>Watch the &amp;demonstration</source>
        <translation>デモを見る(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Mouse and keys</source>
        <translation>マウスとキー(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;About Tactooth</source>
        <translation>Tactooth について(&amp;A)</translation>
    </message>
    <message>
        <source>Mouse and keys</source>
        <translation>マウスとキー</translation>
    </message>
    <message>
        <source>About Tactooth</source>
        <translation>Tactooth について</translation>
    </message>
    <message>
        <source>&lt;b&gt;Tactooth %1&lt;/b&gt; (%2)&lt;br&gt;See, feel and hear a dental bur touch and cut a tooth.&lt;br&gt;&lt;br&gt;Free software under the GNU General Public License, version 3 or later;&lt;br&gt;its simulation library under the Apache License 2.0.</source>
        <translation>&lt;b&gt;Tactooth %1&lt;/b&gt; (%2)&lt;br&gt;歯科用バーが歯に触れ、削るのを見て、感じて、聞く。&lt;br&gt;&lt;br&gt;GNU General Public License バージョン 3 以降によるフリーソフトウェア。&lt;br&gt;シミュレーションのライブラリは Apache License 2.0。</translation>
    </message>
    <message>
        <source>Ma&amp;nual</source>
        <translation>説明書(&amp;N)</translation>
    </message>
</context>
<context>
    <name>tactooth::InstrumentMenus</name>
    <message>
        <source>&amp;Water spray</source>
        <translation>注水スプレー(&amp;W)</translation>
    </message>
    <message>
        <source>Su&amp;ction</source>
        <translation>吸引(&amp;C)</translation>
    </message>
    <message>
        <source>Mirror &amp;glass</source>
        <translation>ミラーの鏡面(&amp;G)</translation>
    </message>
    <message>
        <source>No. %1, %2 mm</source>
        <translation>No. %1、%2 mm</translation>
    </message>
    <message>
        <source>&amp;Fogged</source>
        <translation>曇り(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Drops of spray</source>
        <translation>水滴(&amp;D)</translation>
    </message>
    <message>
        <source>Dims by &amp;itself</source>
        <translation>自然に曇る(&amp;I)</translation>
    </message>
    <message>
        <source>In the mouth, breath fogs the mirror slowly while no spray runs, and what the bur throws soils it. Fogged, switched on and off, wipes the glass. An examination leaves it clear.</source>
        <translation>口の中では、注水していない間に息でミラーがゆっくり曇り、バーの飛ばす削りかすで汚れます。「曇り」を一度入れて切ると、鏡面を拭き取れます。試験中は曇りません。</translation>
    </message>
</context>
<context>
    <name>tactooth::PanelUpdater</name>
    <message>
        <source>mouse</source>
        <translation>マウス</translation>
    </message>
</context>
<context>
    <name>tactooth::RecordExports</name>
    <message>
        <source>Export plots: a table or a picture</source>
        <translation>グラフを書き出す：表または画像</translation>
    </message>
    <message>
        <source>Table (*.csv);;Picture (*.png);;Drawing (*.svg)</source>
        <translation>表 (*.csv);;画像 (*.png);;図面 (*.svg)</translation>
    </message>
    <message>
        <source>The plots were written to %1</source>
        <translation>グラフを %1 に書き出しました</translation>
    </message>
    <message>
        <source>Export what happened</source>
        <translation>できごとを書き出す</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>The list was written to %1</source>
        <translation>一覧を %1 に書き出しました</translation>
    </message>
</context>
<context>
    <name>tactooth::SoundController</name>
    <message>
        <source>Own sounds: a recording of the free-running drive, or a preset</source>
        <translation>自分の音：空転の録音、またはプリセット</translation>
    </message>
    <message>
        <source>Recordings and presets (*.wav *.flac *.ogg *.toml);;All files (*)</source>
        <translation>録音とプリセット (*.wav *.flac *.ogg *.toml);;すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>tactooth::TaskFields</name>
    <message>
        <source>Task</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>How to do it</source>
        <translation>進め方</translation>
    </message>
    <message>
        <source>Bur</source>
        <translation>バー</translation>
    </message>
    <message>
        <source>Other burs</source>
        <translation>ほかのバー</translation>
    </message>
    <message>
        <source>Burs that serve as well</source>
        <translation>代わりに使えるバー</translation>
    </message>
    <message>
        <source>Only these burs</source>
        <translation>これらのバーだけ</translation>
    </message>
    <message>
        <source>The student may take no other bur</source>
        <translation>学生は、ほかのバーを使えません</translation>
    </message>
    <message>
        <source>Instruments</source>
        <translation>器具</translation>
    </message>
    <message>
        <source>What the student may take from the tray; one handpiece at least</source>
        <translation>学生がトレーから取れる器具。ハンドピースは少なくとも一つ</translation>
    </message>
    <message>
        <source>The usual one</source>
        <translation>標準のもの</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>難しさ</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source> min</source>
        <translation> 分</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>制限なし</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>許容差</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Rubric</source>
        <translation>評価基準表</translation>
    </message>
</context>
<context>
    <name>tactooth::ToothController</name>
    <message>
        <source>A recording is shown. Leave the replay to save the tooth.</source>
        <translation>記録を表示しています。歯を保存するには再生を終えてください。</translation>
    </message>
    <message>
        <source>%1 was imported</source>
        <translation>%1 を取り込みました</translation>
    </message>
    <message>
        <source>Making the tooth: %1…</source>
        <translation>歯を作成中：%1…</translation>
    </message>
    <message>
        <source>Making the whole mouth around tooth %1…</source>
        <translation>歯%1のまわりに口全体を作成中…</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 を開いています…</translation>
    </message>
    <message>
        <source>The tooth was written to %1</source>
        <translation>歯を %1 に書き出しました</translation>
    </message>
    <message>
        <source>The tooth was saved to %1</source>
        <translation>歯を %1 に保存しました</translation>
    </message>
    <message>
        <source>Import a folder of scans</source>
        <translation>スキャンのフォルダーの取り込み</translation>
    </message>
    <message>
        <source>Save the case</source>
        <translation>症例を保存</translation>
    </message>
    <message>
        <source>Cases (*.ttcase)</source>
        <translation>症例 (*.ttcase)</translation>
    </message>
    <message>
        <source>Import a scan: surfaces of one tooth</source>
        <translation>スキャンの取り込み：一つの歯の表面</translation>
    </message>
    <message>
        <source>Surfaces (*.stl *.STL *.obj *.OBJ *.ply *.PLY);;All files (*)</source>
        <translation>表面 (*.stl *.STL *.obj *.OBJ *.ply *.PLY);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Open bur: tip at the origin, shaft along +z, mm</source>
        <translation>バーを開く：先端が原点、軸が +z、単位 mm</translation>
    </message>
    <message>
        <source>Burs (*.stl *.STL *.obj *.ply *.toml);;All files (*)</source>
        <translation>バー (*.stl *.STL *.obj *.ply *.toml);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Export cut tooth</source>
        <translation>削った歯を書き出す</translation>
    </message>
    <message>
        <source>STL surfaces (*.stl *.STL);;All files (*)</source>
        <translation>STL 表面 (*.stl *.STL);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Save tooth</source>
        <translation>歯を保存</translation>
    </message>
    <message>
        <source>Saved teeth (*.tactooth);;All files (*)</source>
        <translation>保存した歯 (*.tactooth);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>The examination has begun with this tooth: finish it before you take another one</source>
        <translation>この歯で試験が始まっています。別の歯に替える前に試験を終えてください</translation>
    </message>
    <message>
        <source>Loading was cancelled: the tooth stays as it is</source>
        <translation>読み込みを中止しました。歯はそのままです</translation>
    </message>
    <message>
        <source>Loading</source>
        <translation>読み込み中</translation>
    </message>
    <message>
        <source>Keeps the present tooth; what is being loaded is dropped</source>
        <translation>現在の歯をそのまま残し、読み込みを中止します</translation>
    </message>
    <message>
        <source>Writing the tooth to %1…</source>
        <translation>歯を %1 に書き出しています…</translation>
    </message>
    <message>
        <source>Saving the tooth to %1…</source>
        <translation>歯を %1 に保存しています…</translation>
    </message>
</context>
<context>
    <name>tactooth::ToothFields</name>
    <message>
        <source>Tooth and drawing</source>
        <translation>歯と描画</translation>
    </message>
    <message>
        <source>In the mouth, with its neighbours</source>
        <translation>口腔内（隣在歯あり）</translation>
    </message>
    <message>
        <source>Remove zone</source>
        <translation>禁止域を削除</translation>
    </message>
    <message>
        <source>Tooth</source>
        <translation>歯</translation>
    </message>
    <message>
        <source>Class I</source>
        <translation>1 級</translation>
    </message>
    <message>
        <source>Class II, mesial</source>
        <translation>2 級 近心</translation>
    </message>
    <message>
        <source>Class II, distal</source>
        <translation>2 級 遠心</translation>
    </message>
    <message>
        <source>Class V</source>
        <translation>5 級</translation>
    </message>
    <message>
        <source>Draws the outline of such a cavity on the tooth, in place of the one that is there</source>
        <translation>この窩洞の外形を、いまの外形の代わりに歯に描きます</translation>
    </message>
    <message>
        <source>Free outline</source>
        <translation>自由な外形</translation>
    </message>
    <message>
        <source>Takes the outline away: draw it point by point</source>
        <translation>外形を消します。点を一つずつ描いてください</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>ひな形</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>外形</translation>
    </message>
    <message>
        <source>Forbidden zone</source>
        <translation>切削禁止域</translation>
    </message>
    <message>
        <source>Decay</source>
        <translation>う蝕</translation>
    </message>
    <message>
        <source>New zone</source>
        <translation>新しい禁止域</translation>
    </message>
    <message>
        <source>A click draws</source>
        <translation>クリックで描くもの</translation>
    </message>
</context>
<context>
    <name>tactooth::ViewAidsMenu</name>
    <message>
        <source>&amp;Aids</source>
        <translation>見やすくする(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Glass handpiece</source>
        <translation>透けるハンドピース(&amp;G)</translation>
    </message>
    <message>
        <source>Handles and the shank turn to glass where they hide the bur&apos;s head or the place where it lands</source>
        <translation>柄とシャンクが、バーの頭部や当たる場所を隠すところで透明になります</translation>
    </message>
    <message>
        <source>&amp;Magnifier</source>
        <translation>拡大鏡(&amp;M)</translation>
    </message>
    <message>
        <source>The bur&apos;s head, four times as large, in the upper left corner</source>
        <translation>左上の隅に、バーの頭部を4倍に拡大して表示します</translation>
    </message>
    <message>
        <source>&amp;Scale bar</source>
        <translation>目盛り(&amp;S)</translation>
    </message>
    <message>
        <source>Length in mm at the depth of the tooth</source>
        <translation>歯の位置での長さ（mm）</translation>
    </message>
    <message>
        <source>&amp;Letters of the directions</source>
        <translation>方向の文字(&amp;L)</translation>
    </message>
    <message>
        <source>B buccal, L lingual, M mesial, D distal, O occlusal, A apical</source>
        <translation>B 頬側、L 舌側、M 近心、D 遠心、O 咬合面、A 根尖</translation>
    </message>
    <message>
        <source>View &amp;cube</source>
        <translation>視点キューブ(&amp;C)</translation>
    </message>
    <message>
        <source>Shows the side of the view; a click on a face changes to that side</source>
        <translation>どの側から見ているかを示します。面をクリックすると、そちらから見ます</translation>
    </message>
    <message>
        <source>Cheeks, lips and &amp;tongue</source>
        <translation>頬・口唇・舌(&amp;T)</translation>
    </message>
    <message>
        <source>What surrounds the jaws of the whole mouth. It is left out where it would hide the tooth</source>
        <translation>全顎の周りのものです。歯を隠す所では表示しません</translation>
    </message>
</context>
<context>
    <name>tactooth::ViewCube</name>
    <message>
        <source>Occlusal</source>
        <translation>咬合面</translation>
    </message>
    <message>
        <source>Buccal</source>
        <translation>頬側</translation>
    </message>
    <message>
        <source>Lingual</source>
        <translation>舌側</translation>
    </message>
    <message>
        <source>Mesial</source>
        <translation>近心</translation>
    </message>
    <message>
        <source>Distal</source>
        <translation>遠心</translation>
    </message>
    <message>
        <source>Apical</source>
        <translation>根尖</translation>
    </message>
    <message>
        <source>Click: %1</source>
        <translation>クリック：%1</translation>
    </message>
</context>
<context>
    <name>tactooth::ViewMenu</name>
    <message>
        <source>Aim</source>
        <translation>照準</translation>
    </message>
    <message>
        <source>Shows where the bur will land, and at its tip the depth, the tooth left over the pulp, and the force</source>
        <translation>バーが当たる場所と、先端に深さ、歯髄までの残り、力を表示します</translation>
    </message>
    <message>
        <source>Dentist&apos;s view</source>
        <translation>術者の視点</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>全体表示</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>ミラー</translation>
    </message>
    <message>
        <source>Turbine</source>
        <translation>タービン</translation>
    </message>
    <message>
        <source>Occlusal</source>
        <translation>咬合面</translation>
    </message>
    <message>
        <source>Buccal</source>
        <translation>頬側</translation>
    </message>
    <message>
        <source>Lingual</source>
        <translation>舌側</translation>
    </message>
    <message>
        <source>Mesial</source>
        <translation>近心</translation>
    </message>
    <message>
        <source>Distal</source>
        <translation>遠心</translation>
    </message>
    <message>
        <source>&amp;Second view</source>
        <translation>第二の視点(&amp;S)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>&amp;Place the mirror</source>
        <translation>ミラーを合わせる(&amp;P)</translation>
    </message>
    <message>
        <source>Holds the mirror where it shows the bur from behind</source>
        <translation>バーを後ろから映す位置にミラーを置きます</translation>
    </message>
    <message>
        <source>Put the mirror &amp;back</source>
        <translation>ミラーを戻す(&amp;B)</translation>
    </message>
    <message>
        <source>The mirror waits again behind the tooth</source>
        <translation>ミラーは歯の後ろの待機位置に戻ります</translation>
    </message>
</context>
<context>
    <name>tactooth::WindowHints</name>
    <message>
        <source>Left button: press the instrument on the tooth · wheel: how hard · right: turn</source>
        <translation>左ボタン：器具を歯に押し付ける · ホイール：押す強さ · 右：回す</translation>
    </message>
    <message>
        <source>An instrument in the hand has no drive: take a handpiece from the tray first</source>
        <translation>手用器具は回りません。先にトレーからハンドピースを取ってください</translation>
    </message>
    <message>
        <source>D-pad: control and value · shoulders: panel · A: press · B: back to the tooth</source>
        <translation>十字キー：項目と値 · ショルダー：パネル · A：押す · B：歯に戻る</translation>
    </message>
    <message>
        <source>Left stick: move · left trigger: press · left shoulder: lift · right stick: lean · right trigger: pedal · A: touch or cut · d-pad: turn · Start: menus · Back: panels</source>
        <translation>左スティック：移動 · 左トリガー：押す · 左ショルダー：持ち上げる · 右スティック：傾ける · 右トリガー：ペダル · A：触る／削る · 十字キー：回す · Start：メニュー · Back：パネル</translation>
    </message>
    <message>
        <source>The scene is heavy for this machine: one tick in a hundred takes %1 of the %2 µs that there are; take a tooth of fewer triangles (&apos;tactooth simplify&apos;) or a bur of fewer triangles, and close other programs.</source>
        <translation>このコンピューターには負荷が大きすぎます：100 回に 1 回の計算が、使える %2 µs のうち %1 µs を要しています。三角形の少ない歯（&apos;tactooth simplify&apos;）または三角形の少ないバーを使い、他のプログラムを終了してください。</translation>
    </message>
    <message>
        <source>Blue glass: still to cut, darker where deeper. Dark line: the outline, dashed where the tooth hides it.</source>
        <translation>青いガラス：削り残し（深いほど濃い）。濃い線：外形（歯に隠れたところは破線）。</translation>
    </message>
    <message>
        <source>The bur stands still: hold the pedal (%1), or tick Keep down</source>
        <translation>バーは止まっています。ペダル（%1）を踏み続けるか、「踏んだまま」を選んでください</translation>
    </message>
    <message>
        <source>Left button: press the bur on the tooth · wheel: how deep · right: turn · %1: pedal</source>
        <translation>左ボタン：バーを歯に押す・ホイール：削る深さ・右：回す・%1：ペダル</translation>
    </message>
    <message>
        <source>Move the device: the bur follows it · %1: pedal · %2: cut, %3: touch</source>
        <translation>装置を動かすとバーが従います · %1：ペダル · %2：削る、%3：触る</translation>
    </message>
    <message>
        <source>In Touch the bur stands still: choose Cut (%1), and the pedal turns it</source>
        <translation>触診ではバーは回りません：切削（%1）を選ぶとペダルで回ります</translation>
    </message>
    <message>
        <source>The hand is at the end of the device&apos;s workspace: hold the bur (%1), bring the hand back and let go</source>
        <translation>手が装置の可動域の端にあります。バーを保持して（%1）手を戻し、離してください</translation>
    </message>
    <message>
        <source>The bur only touches: choose Cut (%1) to remove something</source>
        <translation>バーは触れているだけです。削るには「切削」（%1）を選んでください</translation>
    </message>
    <message>
        <source>No place of the mirror shows the bur from behind: turn the tooth, or move the mirror by the mouse</source>
        <translation>バーを後ろから映せるミラーの位置がありません。歯の向きを変えるか、マウスでミラーを動かしてください</translation>
    </message>
    <message>
        <source>As from %1 o&apos;clock, with the mirror held to the chewing surface</source>
        <translation>%1 時の位置からの視点です。ミラーは咬合面を映しています</translation>
    </message>
    <message>
        <source>As from %1 o&apos;clock, without the mirror</source>
        <translation>%1 時の位置からの視点です。ミラーは使いません</translation>
    </message>
</context>
<context>
    <name>tactooth::WindowMenus</name>
    <message>
        <source>&amp;Instruments</source>
        <translation>器具(&amp;I)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Drill</source>
        <translation>ドリル(&amp;D)</translation>
    </message>
    <message>
        <source>Stand the bur &amp;upright</source>
        <translation>バーを垂直に立てる(&amp;U)</translation>
    </message>
    <message>
        <source>Turn the handle &amp;left</source>
        <translation>柄を左に回す(&amp;L)</translation>
    </message>
    <message>
        <source>Turn the handle &amp;right</source>
        <translation>柄を右に回す(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Sound</source>
        <translation>音(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Mute</source>
        <translation>消音(&amp;M)</translation>
    </message>
    <message>
        <source>Reset la&amp;yout</source>
        <translation>配置を元に戻す(&amp;Y)</translation>
    </message>
</context>
<context>
    <name>tactooth::WindowMessages</name>
    <message>
        <source>Tactooth</source>
        <translation>Tactooth</translation>
    </message>
    <message>
        <source>It was cancelled: no file was written or changed</source>
        <translation>取り消しました。ファイルは作られず、変更もされていません</translation>
    </message>
</context>
<context>
    <name>tactooth::OpenToothDialog</name>
    <message>
        <source>Open tooth</source>
        <translation>歯を開く</translation>
    </message>
    <message>
        <source>The tooth&apos;s outer surface is touched and drawn. Closed surfaces inside it say where each tissue is; without them the whole tooth is enamel. STL files in millimetres, or a case or a saved tooth, which have all of these.</source>
        <translation>歯の外表面は触れて見える面です。内部の閉じた表面が各組織の場所を示します。なければ歯全体をエナメル質とします。ミリメートル単位の STL ファイル、またはこれらをすべて含む症例か保存した歯を指定してください。</translation>
    </message>
    <message>
        <source>Outer surface</source>
        <translation>外面</translation>
    </message>
    <message>
        <source>The whole tooth, a case or a saved one, needed</source>
        <translation>歯全体、症例、または保存した歯（必須）</translation>
    </message>
    <message>
        <source>Optional</source>
        <translation>任意</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>参照…</translation>
    </message>
    <message>
        <source>Surfaces, cases and saved teeth (*.stl *.STL *.obj *.OBJ *.ply *.PLY *.ttcase case.toml *.tactooth);;All files (*)</source>
        <translation>表面・症例・保存した歯 (*.stl *.STL *.obj *.OBJ *.ply *.PLY *.ttcase case.toml *.tactooth);;すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>tactooth::PlotPanel</name>
    <message>
        <source>Speed, mm/s</source>
        <translation>速度 mm/s</translation>
    </message>
    <message>
        <source>Force, N</source>
        <translation>力 N</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>一時停止</translation>
    </message>
    <message>
        <source>Holds the plots still, to look at them or to export them; the simulation goes on</source>
        <translation>グラフを止めて見たり書き出したりできます。シミュレーションは続きます</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出す…</translation>
    </message>
    <message>
        <source>Writes what is shown: a table (CSV) or a picture (PNG, SVG)</source>
        <translation>表示中の内容を表（CSV）または画像（PNG、SVG）に書き出します</translation>
    </message>
    <message>
        <source> s</source>
        <translation> 秒</translation>
    </message>
    <message>
        <source>How much time is shown; the mouse wheel over a plot changes it too</source>
        <translation>表示する時間の長さ。グラフ上のホイールでも変えられます</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>表示時間</translation>
    </message>
    <message>
        <source>Cavity depth, mm</source>
        <translation>窩洞の深さ、mm</translation>
    </message>
    <message>
        <source>How deep the tip of the bur is below the uncut surface, along its shaft</source>
        <translation>切削前の表面から見たバー先端の深さ（バーの軸に沿った値）</translation>
    </message>
    <message>
        <source>Penetration depth, mm</source>
        <translation>侵入量、mm</translation>
    </message>
    <message>
        <source>How far the hand is behind the surface that the bur touches: it grows with the force</source>
        <translation>バーが触れている表面より手がどれだけ奥にあるか。力とともに大きくなります</translation>
    </message>
    <message>
        <source>Speed of the hand at the tip of the bur</source>
        <translation>バー先端での手の速さ</translation>
    </message>
    <message>
        <source>Force on the hand</source>
        <translation>手にかかる力</translation>
    </message>
</context>
<context>
    <name>tactooth::SoundPanel</name>
    <message>
        <source>The turbine&apos;s own tone and its air</source>
        <translation>タービンの音と空気音</translation>
    </message>
    <message>
        <source>The bur in the tooth</source>
        <translation>歯を削る音</translation>
    </message>
    <message>
        <source>Spray and suction</source>
        <translation>注水とバキューム</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>すべての音</translation>
    </message>
    <message>
        <source>Mute</source>
        <translation>消音</translation>
    </message>
    <message>
        <source>Headphones</source>
        <translation>ヘッドホン</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>部屋</translation>
    </message>
    <message>
        <source>Adds the sound of the surgery around the chair</source>
        <translation>診療室の響きを加えます</translation>
    </message>
    <message>
        <source>Places the sounds around the head, as two ears hear them; for loudspeakers leave it off</source>
        <translation>両耳で聞くように音を頭の周りに配置します。スピーカーではオフにします</translation>
    </message>
    <message>
        <source>Turbine</source>
        <translation>タービン</translation>
    </message>
    <message>
        <source>Cutting</source>
        <translation>切削音</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>水</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>Sounds</source>
        <translation>音源</translation>
    </message>
    <message>
        <source>Synthesised</source>
        <translation>合成音</translation>
    </message>
    <message>
        <source>Own recordings…</source>
        <translation>自分の録音…</translation>
    </message>
</context>
<context>
    <name>tactooth::StatusLine</name>
    <message>
        <source>Nothing removed yet</source>
        <translation>まだ何も削っていません</translation>
    </message>
    <message>
        <source>Removed: %1 mm³</source>
        <translation>切削量：%1 mm³</translation>
    </message>
    <message>
        <source>Servo %1 Hz, p99 %2 µs, missed %3, %4  |  surface %5/s</source>
        <translation>サーボ %1 Hz、p99 %2 µs、欠落 %3、%4  |  表面 %5/秒</translation>
    </message>
    <message>
        <source>real-time</source>
        <translation>リアルタイム</translation>
    </message>
    <message>
        <source>not real-time</source>
        <translation>リアルタイムでない</translation>
    </message>
    <message>
        <source>Force late</source>
        <translation>力が遅れています</translation>
    </message>
    <message>
        <source>Force on time</source>
        <translation>力の遅れなし</translation>
    </message>
    <message>
        <source>In the last second %1 % of the force came too late.</source>
        <translation>直前の1秒間に、力の %1 % が間に合いませんでした。</translation>
    </message>
    <message>
        <source>More than 1 % is felt: close other programs, or take a tooth with fewer triangles.</source>
        <translation>1 %を超えると手に感じられます。他のプログラムを閉じるか、三角形の少ない歯を使ってください。</translation>
    </message>
    <message>
        <source>The panel Real time shows more.</source>
        <translation>詳しくは「リアルタイム」パネルをご覧ください。</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>中止</translation>
    </message>
</context>
<context>
    <name>tactooth::WelcomeDialog</name>
    <message>
        <source>Welcome to Tactooth</source>
        <translation>Tactooth へようこそ</translation>
    </message>
    <message>
        <source>See, feel and hear a bur touch and cut a tooth. What would you like to do?</source>
        <translation>バーが歯に触れ、削るのを見て、感じて、聞いてください。何をしますか？</translation>
    </message>
    <message>
        <source>Practise</source>
        <translation>練習する</translation>
    </message>
    <message>
        <source>A lower molar with a carious lesion is ready: move the mouse over it and press.</source>
        <translation>う蝕のある下顎大臼歯が用意されています：マウスを重ねて押してください。</translation>
    </message>
    <message>
        <source>Open my tooth</source>
        <translation>自分の歯を開く</translation>
    </message>
    <message>
        <source>A scan of your own, in any unit and position: you first see what the program assumes.</source>
        <translation>自分のスキャン。単位や向きは問いません。プログラムが何を仮定したかを先に確かめられます。</translation>
    </message>
    <message>
        <source>Watch the demonstration</source>
        <translation>デモを見る</translation>
    </message>
    <message>
        <source>Twenty seconds: touching, cutting, taking back.</source>
        <translation>20秒：触れる、削る、取り消す。</translation>
    </message>
    <message>
        <source>Read the manual</source>
        <translation>説明書を読む</translation>
    </message>
    <message>
        <source>The first ten minutes, keys, exercises and reports; also with F1.</source>
        <translation>最初の10分、キー、課題、レポート。F1 キーでも開きます。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Show this page at each start</source>
        <translation>起動のたびにこのページを表示</translation>
    </message>
    <message>
        <source>Recent work</source>
        <translation>最近の作業</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>d MMM</source>
        <translation>M月d日</translation>
    </message>
    <message>
        <source>Case, %1</source>
        <translation>症例、%1</translation>
    </message>
    <message>
        <source>Scan, %1</source>
        <translation>スキャン、%1</translation>
    </message>
    <message>
        <source>Exercise, %1</source>
        <translation>課題、%1</translation>
    </message>
    <message>
        <source>Recording, %1</source>
        <translation>記録、%1</translation>
    </message>
    <message>
        <source>Tooth, %1</source>
        <translation>歯、%1</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
</context>
<context>
    <name>tactooth::WelcomeEntry</name>
    <message>
        <source>&amp;Welcome…</source>
        <translation>ようこそ(&amp;W)…</translation>
    </message>
    <message>
        <source>Exercises, recent work, the manual and the language</source>
        <translation>課題、最近の作業、説明書、言語</translation>
    </message>
</context>
<context>
    <name>tactooth::DevicePanel</name>
    <message>
        <source>Rate</source>
        <translation>更新周波数</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>How often the force is computed: 500 Hz for a slow machine, where walls feel half as stiff; more than 1000 Hz for a smoother force, if the device&apos;s driver allows it</source>
        <translation>力を計算し直す頻度です。遅いコンピューターでは 500 Hz（壁の硬さは半分になります）、デバイスのドライバーが対応していれば 1000 Hz より高くすると力が滑らかになります</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>準備完了</translation>
    </message>
    <message>
        <source>The force is on.</source>
        <translation>力はオンです。</translation>
    </message>
    <message>
        <source>The force is off.</source>
        <translation>力はオフです。</translation>
    </message>
    <message>
        <source>The force waits until the bur is free: lift it off the tooth.</source>
        <translation>バーが歯から離れるまで力は出ません。歯から持ち上げてください。</translation>
    </message>
    <message>
        <source>The motors are warm: the force is weaker.</source>
        <translation>モーターが熱くなっているため、力を弱めています。</translation>
    </message>
    <message>
        <source>No force: the device is not there or its reading is wrong.</source>
        <translation>力なし：装置がないか、読み取り値が正しくありません。</translation>
    </message>
    <message>
        <source>Other hand</source>
        <translation>もう一方の手</translation>
    </message>
    <message>
        <source>empty</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>A second device, which begins with the mirror; a button exchanges what the hands hold</source>
        <translation>2台目の装置。最初はミラーを持ち、ボタンで両手の持ち物を入れ替えます</translation>
    </message>
    <message>
        <source>Hold the bur</source>
        <translation>バーを保持</translation>
    </message>
    <message>
        <source>Left-handed</source>
        <translation>左利き</translation>
    </message>
    <message>
        <source>Teach…</source>
        <translation>教える…</translation>
    </message>
    <message>
        <source>Motion scaling</source>
        <translation>モーションスケーリング</translation>
    </message>
    <message>
        <source> : 1</source>
        <translation> : 1</translation>
    </message>
    <message>
        <source>How far the device moves for each millimetre of the bur: 3 : 1 for fine work</source>
        <translation>バーが1 mm動くごとに装置の手が動く距離。細かい作業には3 : 1</translation>
    </message>
    <message>
        <source>Fit to the tooth</source>
        <translation>歯に合わせる</translation>
    </message>
    <message>
        <source>As fine as possible while the device still reaches all of the tooth</source>
        <translation>装置の可動域で歯全体に届く範囲で、できるだけ細かくします</translation>
    </message>
    <message>
        <source>No device here has a known workspace: 1 : 1.</source>
        <translation>合わせられる可動域を持つ装置がありません：1 : 1。</translation>
    </message>
    <message>
        <source>What moves the bur. Plug it in before you choose it.</source>
        <translation>バーを動かす装置。接続してから選んでください。</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>装置</translation>
    </message>
    <message>
        <source>Handles point to the other side, and the two sides of a gamepad are swapped</source>
        <translation>ハンドルが反対側に出て、ゲームパッドの左右が入れ替わります</translation>
    </message>
    <message>
        <source>Turbine or mirror</source>
        <translation>タービン／ミラー</translation>
    </message>
    <message>
        <source>Touch or cut</source>
        <translation>触る／削る</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>no button</source>
        <translation>ボタンなし</translation>
    </message>
    <message>
        <source>button %1</source>
        <translation>ボタン %1</translation>
    </message>
    <message>
        <source>Any axis or button of a joystick can be the pedal: press it fully and let it go</source>
        <translation>ジョイスティックのどの軸やボタンもペダルにできます。いっぱいに踏んで離してください</translation>
    </message>
    <message>
        <source>The key that is the pedal as long as it is held</source>
        <translation>押している間ペダルになるキー</translation>
    </message>
    <message>
        <source>Foot pedal</source>
        <translation>フットペダル</translation>
    </message>
    <message>
        <source>Pedal key</source>
        <translation>ペダルのキー</translation>
    </message>
    <message>
        <source>key and slider</source>
        <translation>キーとスライダー</translation>
    </message>
    <message>
        <source>The mouse steers; the meter shows what a hand would feel.</source>
        <translation>マウスで動かします。手が感じる力はメーターに表示されます。</translation>
    </message>
    <message>
        <source>The bur stays while the hand goes back to a comfortable place; a key or a button of the device does the same</source>
        <translation>手を楽な位置に戻す間、バーはその場にとどまります。キーや装置のボタンでも同じことができます</translation>
    </message>
    <message>
        <source>The tooth is larger than the device&apos;s workspace: hold the bur (%1) to reach all of it.</source>
        <translation>歯が装置の可動域より大きいので、全体に届くにはバーを保持（%1）してください。</translation>
    </message>
</context>
<context>
    <name>tactooth::ScanPreview</name>
    <message>
        <source>The scan as it will stand</source>
        <translation>取り込み後の向きのスキャン</translation>
    </message>
    <message>
        <source>Click on the side of the cheek or lip. Drag to turn, wheel to zoom.</source>
        <translation>頬または唇の側をクリックしてください。ドラッグで回転、ホイールで拡大します。</translation>
    </message>
</context>
<context>
    <name>tactooth::CaseDialog</name>
    <message>
        <source>%1, number unknown: choose its quadrant</source>
        <translation>%1、番号不明（区分を選んでください）</translation>
    </message>
    <message>
        <source>%1, tooth %2 (FDI)</source>
        <translation>%1、歯 %2（FDI）</translation>
    </message>
    <message>
        <source>Make a case from a folder of scans</source>
        <translation>スキャンのフォルダーから症例を作る</translation>
    </message>
    <message>
        <source>What the case holds, and what was assumed and repaired:</source>
        <translation>症例の内容と、仮定・修復したこと：</translation>
    </message>
    <message>
        <source>Save and open…</source>
        <translation>保存して開く…</translation>
    </message>
    <message>
        <source>As the names of the files say</source>
        <translation>ファイル名のとおり</translation>
    </message>
    <message>
        <source>Upper right (1)</source>
        <translation>上顎右側 (1)</translation>
    </message>
    <message>
        <source>Upper left (2)</source>
        <translation>上顎左側 (2)</translation>
    </message>
    <message>
        <source>Lower left (3)</source>
        <translation>下顎左側 (3)</translation>
    </message>
    <message>
        <source>Lower right (4)</source>
        <translation>下顎右側 (4)</translation>
    </message>
    <message>
        <source>Where a name ends in a single digit, as L6, it is a tooth of this quarter of the mouth</source>
        <translation>L6 のように 1 桁の数字で終わる名前を、この区分の歯とみなします</translation>
    </message>
    <message>
        <source>Quadrant</source>
        <translation>区分（1/4 顎）</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内部</translation>
    </message>
    <message>
        <source>Reading the surfaces…</source>
        <translation>表面を読み込んでいます…</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation>%1 を取り込んでいます…</translation>
    </message>
    <message>
        <source>Teeth: %1. Bodies around them: %2.</source>
        <translation>歯：%1 本。周囲の物体：%2 個。</translation>
    </message>
</context>
<context>
    <name>tactooth::ImportDialog</name>
    <message>
        <source>Import a scan</source>
        <translation>スキャンの取り込み</translation>
    </message>
    <message>
        <source>Reading the surface…</source>
        <translation>表面を読み込んでいます…</translation>
    </message>
    <message>
        <source>Looking at the surface…</source>
        <translation>表面を調べています…</translation>
    </message>
    <message>
        <source>Making the layers inside the tooth…</source>
        <translation>歯の内部の層を作っています…</translation>
    </message>
    <message>
        <source>What was assumed and repaired:</source>
        <translation>仮定したことと修復したこと：</translation>
    </message>
    <message>
        <source>Guessed</source>
        <translation>推定</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Crown and root the other way up</source>
        <translation>歯冠と歯根を上下逆にする</translation>
    </message>
    <message>
        <source>Turn about the long axis</source>
        <translation>長軸まわりの回転</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>穴</translation>
    </message>
    <message>
        <source>Fill small ones</source>
        <translation>小さい穴をふさぐ</translation>
    </message>
    <message>
        <source>Fill all of them</source>
        <translation>すべての穴をふさぐ</translation>
    </message>
    <message>
        <source>Leave them open</source>
        <translation>開いたままにする</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内部</translation>
    </message>
    <message>
        <source>A model of enamel, dentin and pulp</source>
        <translation>エナメル質・象牙質・歯髄のモデル</translation>
    </message>
    <message>
        <source>Enamel all through</source>
        <translation>全体をエナメル質とする</translation>
    </message>
    <message>
        <source>Also keep it as a case: %1</source>
        <translation>症例としても保存する：%1</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>取り込む</translation>
    </message>
    <message>
        <source>%1 triangles, %2 x %3 x %4 mm</source>
        <translation>三角形 %1 個、%2 × %3 × %4 mm</translation>
    </message>
    <message>
        <source>Click on the side of the cheek or lip: it becomes buccal (B).</source>
        <translation>頬または唇の側をクリックすると、そこが頬側（B）になります。</translation>
    </message>
</context>
<context>
    <name>tactooth::EventPanel</name>
    <message>
        <source>What happened</source>
        <translation>できごと</translation>
    </message>
    <message>
        <source>Time, s</source>
        <translation>時刻 (秒)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Where, mm</source>
        <translation>位置 (mm)</translation>
    </message>
    <message>
        <source>A double click shows the place in the middle of the picture</source>
        <translation>ダブルクリックすると、その場所が画面の中央に表示されます</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出し…</translation>
    </message>
    <message>
        <source>Writes the list as a table (CSV)</source>
        <translation>一覧を表 (CSV) として書き出します</translation>
    </message>
    <message>
        <source>At %1 s: %2</source>
        <translation>%1 秒：%2</translation>
    </message>
    <message>
        <source>Taken back: it does not count</source>
        <translation>取り消し済み：数えません</translation>
    </message>
</context>
<context>
    <name>tactooth::ExercisePanel</name>
    <message>
        <source>Marked by the rubric: %1</source>
        <translation>採点に使う評価基準表：%1</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>What to practise: brings the tooth, the bur and the ghost of the ideal cavity</source>
        <translation>練習する内容：歯とバー、理想窩洞の透視表示を用意します</translation>
    </message>
    <message>
        <source>Free practice</source>
        <translation>自由練習</translation>
    </message>
    <message>
        <source>%1 of %2:00</source>
        <translation>%1 / %2:00</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>やり直す</translation>
    </message>
    <message>
        <source>The whole tooth again, and the time from its first contact</source>
        <translation>歯を元に戻し、時間は最初の接触から数え直します</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>報告書…</translation>
    </message>
    <message>
        <source>An exercise of your own: a TOML file (docs/exercises.md)</source>
        <translation>自作の課題: TOML ファイル (docs/exercises.md)</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>開く…</translation>
    </message>
    <message>
        <source>Writes time, volumes and what happened as a table (CSV)</source>
        <translation>時間、削除量、できごとを表 (CSV) として書き出します</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Since the first contact</source>
        <translation>最初の接触から</translation>
    </message>
    <message>
        <source>Share of the ideal cavity that is cut</source>
        <translation>理想窩洞のうち削った割合</translation>
    </message>
    <message>
        <source>%1 removed</source>
        <translation>%1の削除量</translation>
    </message>
    <message>
        <source>Choose an exercise, or a target of your own under Look inside.</source>
        <translation>課題を選ぶか、「内部を見る」で自分の目標を選んでください。</translation>
    </message>
    <message>
        <source>%1 mm³</source>
        <translation>%1 mm³</translation>
    </message>
    <message>
        <source>%p % of the cavity</source>
        <translation>窩洞の %p %</translation>
    </message>
    <message>
        <source>no ideal cavity</source>
        <translation>理想窩洞なし</translation>
    </message>
    <message>
        <source>&amp;Continue exercise</source>
        <translation>課題を続ける(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Finish exercise</source>
        <translation>課題を終える(&amp;F)</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>続ける</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>終了</translation>
    </message>
    <message>
        <source>The time of the exercise goes on</source>
        <translation>課題の時間の計測を続けます</translation>
    </message>
    <message>
        <source>The time stops, and the report shows the mark and what it is made of</source>
        <translation>時間を止め、評点とその内訳を報告書に示します</translation>
    </message>
</context>
<context>
    <name>tactooth::HistogramView</name>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
</context>
<context>
    <name>tactooth::TimingPanel</name>
    <message>
        <source>Histogram of the servo&apos;s ticks</source>
        <translation>サーボの周期のヒストグラム</translation>
    </message>
    <message>
        <source>Histograms of the computing time and of the wake-up latency of the ticks. A time at the dashed line or beyond it means a missed tick.</source>
        <translation>周期の計算時間と起床の遅れのヒストグラムです。破線に達した時間は、1 周期を逃したことを示します。</translation>
    </message>
    <message>
        <source>tick duration, µs</source>
        <translation>1 周期の計算、µs</translation>
    </message>
    <message>
        <source>picture in motion, ms</source>
        <translation>動いている間の画像、ms</translation>
    </message>
    <message>
        <source>wake-up latency, µs</source>
        <translation>起床の遅れ、µs</translation>
    </message>
    <message>
        <source>period jitter, µs</source>
        <translation>周期のずれ、µs</translation>
    </message>
    <message>
        <source>reading to force, µs</source>
        <translation>読み取りから力まで、µs</translation>
    </message>
    <message>
        <source>max</source>
        <translation>最大</translation>
    </message>
    <message>
        <source>Count anew</source>
        <translation>数え直す</translation>
    </message>
    <message>
        <source>Clears all ticks so far, for example those of the program&apos;s start</source>
        <translation>プログラムの起動時のものなど、これまでの周期の記録を消します</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>%1 ticks, %2 missed (%3 %)</source>
        <translation>%1 周期、欠落 %2（%3 %）</translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation>装置：%1</translation>
    </message>
    <message>
        <source>Real-time priority</source>
        <translation>リアルタイム優先度</translation>
    </message>
    <message>
        <source>Ordinary priority (see &apos;tactooth doctor&apos;)</source>
        <translation>通常の優先度（&apos;tactooth doctor&apos; を参照）</translation>
    </message>
    <message>
        <source>Memory locked</source>
        <translation>メモリ固定済み</translation>
    </message>
    <message>
        <source>Memory may be swapped out (see &apos;tactooth doctor&apos;)</source>
        <translation>メモリはスワップされることがあります（&apos;tactooth doctor&apos; を参照）</translation>
    </message>
    <message>
        <source>Processors kept from deep sleep</source>
        <translation>プロセッサーの深いスリープを抑止中</translation>
    </message>
    <message>
        <source>Processors may sleep deeply (see &apos;tactooth doctor&apos;)</source>
        <translation>プロセッサーが深くスリープすることがあります（&apos;tactooth doctor&apos; を参照）</translation>
    </message>
    <message>
        <source>tick duration</source>
        <translation>1 周期の計算</translation>
    </message>
    <message>
        <source>wake-up latency</source>
        <translation>起床の遅れ</translation>
    </message>
</context>
<context>
    <name>tactooth::SecondViewFrame</name>
    <message>
        <source>Click: the large picture looks from there</source>
        <translation>クリック：大きな画面をこの向きにします</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>English</source>
        <extracomment>The English name of the language of this catalogue.</extracomment>
        <translation>Japanese</translation>
    </message>
</context>
<context>
    <name>tactooth::HistoryActions</name>
    <message>
        <source>Drive</source>
        <translation>駆動装置</translation>
    </message>
    <message>
        <source>Water spray</source>
        <translation>注水</translation>
    </message>
    <message>
        <source>Suction</source>
        <translation>バキューム</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>ミラー</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Look inside</source>
        <translation>内部を見る</translation>
    </message>
    <message>
        <source>Going back</source>
        <translation>元に戻しています</translation>
    </message>
    <message>
        <source>Undo and redo</source>
        <translation>取り消しとやり直し</translation>
    </message>
    <message>
        <source>Brings back the tooth as it was before</source>
        <translation>歯を前の状態に戻します</translation>
    </message>
</context>
<context>
    <name>tactooth::HistoryPanel</name>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>A click goes to that state; what comes after it can be redone until you do something else</source>
        <translation>クリックするとその状態に移ります。それより後のことは、別の操作をするまでやり直せます</translation>
    </message>
    <message>
        <source>The tooth as it was opened</source>
        <translation>開いたときの歯</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
</context>
<context>
    <name>tactooth::RecordingController</name>
    <message>
        <source>● Recording</source>
        <translation>● 記録中</translation>
    </message>
    <message>
        <source>&amp;Record sessions</source>
        <translation>セッションを記録する(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Open folder</source>
        <translation>フォルダーを開く(&amp;O)</translation>
    </message>
    <message>
        <source>This session is recorded on this computer, so that nothing is lost; see the menu File.</source>
        <translation>何も失われないように、このセッションをこのコンピューターに記録しています。「ファイル」メニューを見てください。</translation>
    </message>
    <message>
        <source>Recor&amp;dings</source>
        <translation>記録(&amp;D)</translation>
    </message>
    <message>
        <source>No folder</source>
        <translation>フォルダーなし</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>The recordings are in %1</source>
        <translation>記録は %1 にあります</translation>
    </message>
    <message>
        <source>Recording begins with the next tooth</source>
        <translation>次の歯から記録を始めます</translation>
    </message>
    <message>
        <source>● Examination, signed</source>
        <translation>● 試験（署名付き）</translation>
    </message>
    <message>
        <source>The session is recorded again, in another file</source>
        <translation>別のファイルでセッションの記録を再開しました</translation>
    </message>
</context>
<context>
    <name>tactooth::RestoreController</name>
    <message>
        <source>Unfinished session</source>
        <translation>終わっていないセッション</translation>
    </message>
    <message>
        <source>Restore the session of %1?</source>
        <translation>%1 のセッションを復元しますか？</translation>
    </message>
    <message>
        <source>Tactooth did not end as usual then. The tooth: %1</source>
        <translation>そのとき Tactooth は正常に終了しませんでした。歯：%1</translation>
    </message>
    <message>
        <source>The system closed Tactooth then, with unsaved cuts. The tooth: %1</source>
        <translation>そのとき、保存していない切削があるままシステムが Tactooth を終了しました。歯：%1</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>復元(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Keep the file</source>
        <translation>ファイルを残す(&amp;K)</translation>
    </message>
    <message>
        <source>It stays in the folder of recordings, and this question does not come again</source>
        <translation>記録のフォルダーに残し、もう尋ねません</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>破棄(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>後で(&amp;L)</translation>
    </message>
    <message>
        <source>The file is %1</source>
        <translation>ファイルは %1 です</translation>
    </message>
    <message>
        <source>Restoring the session…</source>
        <translation>セッションを復元しています…</translation>
    </message>
</context>
<context>
    <name>tactooth::UnsavedWork</name>
    <message>
        <source>Unsaved cuts</source>
        <translation>保存していない切削</translation>
    </message>
    <message>
        <source>The tooth has cuts that are not saved. Save it first?</source>
        <translation>この歯には保存していない切削があります。先に保存しますか？</translation>
    </message>
</context>
<context>
    <name>tactooth::ExaminationController</name>
    <message>
        <source>Begin exa&amp;mination</source>
        <translation>試験を始める(&amp;M)</translation>
    </message>
    <message>
        <source>Finish exa&amp;mination…</source>
        <translation>試験を終える(&amp;M)…</translation>
    </message>
    <message>
        <source>An examination is recorded, and this window keeps no recordings: start Tactooth without --no-record.</source>
        <translation>試験は記録されますが、このウィンドウは記録を残しません。--no-record を付けずに Tactooth を起動してください。</translation>
    </message>
    <message>
        <source>An examination begins with a tooth that nobody has touched: choose the exercise once more, or open the tooth again.</source>
        <translation>試験は、まだ触れられていない歯で始めます。課題を選び直すか、歯を開き直してください。</translation>
    </message>
    <message>
        <source>Examination</source>
        <translation>試験</translation>
    </message>
    <message>
        <source>Finish the examination?</source>
        <translation>試験を終えますか？</translation>
    </message>
    <message>
        <source>The recording is signed and closed; nothing can be added to it afterwards.</source>
        <translation>記録に署名して閉じます。その後は何も追加できません。</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>終える(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>続ける(&amp;G)</translation>
    </message>
    <message>
        <source>Examination: what you do is recorded and signed. There is no undo.</source>
        <translation>試験中：操作は記録され、署名されます。元に戻すことはできません。</translation>
    </message>
    <message>
        <source>The examination is over: its recording is signed and closed</source>
        <translation>試験が終わりました。記録は署名され、閉じられています</translation>
    </message>
</context>
<context>
    <name>tactooth::ViewOverlays</name>
    <message>
        <source>cut too deep</source>
        <translation>削りすぎ</translation>
    </message>
    <message>
        <source>still to cut</source>
        <translation>まだ削る所</translation>
    </message>
    <message>
        <source>within</source>
        <translation>許容差</translation>
    </message>
</context>
<context>
    <name>tactooth::KeyEditor</name>
    <message>
        <source>Keys</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>操作</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>キー</translation>
    </message>
    <message>
        <source>Usual key</source>
        <translation>最初のキー</translation>
    </message>
    <message>
        <source>&amp;Change…</source>
        <translation>変える(&amp;C)…</translation>
    </message>
    <message>
        <source>&amp;Usual key</source>
        <translation>最初のキー(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;All usual keys</source>
        <translation>すべて最初のキー(&amp;A)</translation>
    </message>
    <message>
        <source>press a key…</source>
        <translation>キーを押す…</translation>
    </message>
    <message>
        <source>Press the new key for “%1”. A click elsewhere leaves the key as it is.</source>
        <translation>「%1」の新しいキーを押してください。ほかの場所をクリックすると、キーはそのまま残ります。</translation>
    </message>
    <message>
        <source>All keys are the usual ones.</source>
        <translation>すべてのキーを最初の設定に戻しました。</translation>
    </message>
</context>
<context>
    <name>tactooth::ManualWindow</name>
    <message>
        <source>Manual of Tactooth</source>
        <translation>Tactooth の説明書</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>進む</translation>
    </message>
    <message>
        <source>Search all pages (Ctrl+F)</source>
        <translation>すべてのページを検索（Ctrl+F）</translation>
    </message>
    <message>
        <source>Search all pages</source>
        <translation>すべてのページを検索</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目次</translation>
    </message>
    <message>
        <source>Places found</source>
        <translation>見つかった場所</translation>
    </message>
    <message>
        <source>No page has these words.</source>
        <translation>この語を含むページはありません。</translation>
    </message>
</context>
<context>
    <name>tactooth::SettingRow</name>
    <message>
        <source>usually %1</source>
        <translation>最初の値：%1</translation>
    </message>
</context>
<context>
    <name>tactooth::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>A change acts at once. Another language opens the window anew, with the work as it is.</source>
        <translation>変更はすぐに働きます。言語を変えると、作業はそのままでウィンドウが開き直します。</translation>
    </message>
    <message>
        <source>&amp;Keys…</source>
        <translation>キー(&amp;K)…</translation>
    </message>
    <message>
        <source>Reset this &amp;page</source>
        <translation>このページを最初の値に(&amp;P)</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>すべて最初の値に(&amp;A)</translation>
    </message>
</context>
<context>
    <name>tactooth::BurDialog</name>
    <message>
        <source>Burs</source>
        <translation>バー</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search: shape, number, ISO number or size</source>
        <translation>検索：形、番号、ISO番号、寸法</translation>
    </message>
    <message>
        <source>Fa&amp;vourites only</source>
        <translation>お気に入りだけ(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Favourite (space)</source>
        <translation>お気に入り（スペース）(&amp;F)</translation>
    </message>
    <message>
        <source>No bur is like this</source>
        <translation>当てはまるバーはありません</translation>
    </message>
</context>
<context>
    <name>tactooth::BurEntry</name>
    <message>
        <source>&amp;Burs…</source>
        <translation>バー(&amp;B)…</translation>
    </message>
    <message>
        <source>Chooses a bur by its picture</source>
        <translation>絵からバーを選びます</translation>
    </message>
</context>
<context>
    <name>tactooth::BurGrid</name>
    <message>
        <source>Burs</source>
        <translation>バー</translation>
    </message>
    <message>
        <source>Used in this exercise</source>
        <translation>この演習で使うバー</translation>
    </message>
    <message>
        <source>Favourite</source>
        <translation>お気に入り</translation>
    </message>
</context>
<context>
    <name>tactooth::BurList</name>
    <message>
        <source>From files</source>
        <translation>ファイルから</translation>
    </message>
    <message>
        <source>Diameter %1 mm</source>
        <translation>直径 %1 mm</translation>
    </message>
    <message>
        <source>Head length %1 mm</source>
        <translation>頭部の長さ %1 mm</translation>
    </message>
</context>
<context>
    <name>tactooth::MeasureMenu</name>
    <message>
        <source>M&amp;easure</source>
        <translation>計測(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>距離(&amp;D)</translation>
    </message>
    <message>
        <source>Two clicks: the straight distance between two places, in mm</source>
        <translation>2回クリック：2点間の直線距離（mm）</translation>
    </message>
    <message>
        <source>&amp;Angle between walls</source>
        <translation>壁の間の角度(&amp;A)</translation>
    </message>
    <message>
        <source>Two clicks: the angle between the normals of the surface at two places, in degrees</source>
        <translation>2回クリック：2か所の面の法線がなす角度（度）</translation>
    </message>
    <message>
        <source>&amp;Taper of walls</source>
        <translation>壁のテーパー(&amp;T)</translation>
    </message>
    <message>
        <source>Two clicks on opposite walls: how far both lean from the direction of insertion, together, in degrees</source>
        <translation>向かい合う壁を2回クリック：装着方向からの傾きの合計（度）</translation>
    </message>
    <message>
        <source>&amp;Remaining dentin</source>
        <translation>残存象牙質(&amp;R)</translation>
    </message>
    <message>
        <source>One click: the straight distance from a place to the pulp, in mm</source>
        <translation>1回クリック：その場所から歯髄までの直線距離（mm）</translation>
    </message>
    <message>
        <source>&amp;Clear, and end</source>
        <translation>消す、終わる(&amp;C)</translation>
    </message>
</context>
<context>
    <name>tactooth::MeasureOverlay</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Angle between walls: normals over discs of %1 mm radius</source>
        <translation>壁の間の角度：半径 %1 mm の円板で平均した法線</translation>
    </message>
    <message>
        <source>Distance from place to place</source>
        <translation>2点間の距離</translation>
    </message>
    <message>
        <source>%1 (%2°, %3°)</source>
        <translation>%1（%2°、%3°）</translation>
    </message>
    <message>
        <source>%1, undercut</source>
        <translation>%1、アンダーカット</translation>
    </message>
    <message>
        <source>Taper: how far two opposite walls lean from the direction of insertion</source>
        <translation>テーパー：向かい合う2つの壁の、装着方向からの傾き</translation>
    </message>
    <message>
        <source>Remaining dentin: straight to the pulp</source>
        <translation>残存象牙質：歯髄までの直線距離</translation>
    </message>
    <message>
        <source>This tooth has no pulp. Esc: clear</source>
        <translation>この歯には歯髄がありません。Esc：消す</translation>
    </message>
    <message>
        <source>These are not two opposite walls. Click again. Esc: clear</source>
        <translation>向かい合う2つの壁ではありません。もう一度クリック。Esc：消す</translation>
    </message>
    <message>
        <source>Click a place. Esc: end</source>
        <translation>場所をクリック。Esc：終わる</translation>
    </message>
    <message>
        <source>Click the second place. Esc: clear</source>
        <translation>2か所目をクリック。Esc：消す</translation>
    </message>
    <message>
        <source>Click the first place. Esc: end</source>
        <translation>1か所目をクリック。Esc：終わる</translation>
    </message>
    <message>
        <source>Click to measure again. Esc: clear</source>
        <translation>クリックで測り直す。Esc：消す</translation>
    </message>
</context>
<context>
    <name>tactooth::ToothChart</name>
    <message>
        <source>Tooth chart</source>
        <translation>歯列図</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>, on the bench</source>
        <translation>（作業中の歯）</translation>
    </message>
    <message>
        <source>; exercise: %1</source>
        <translation>、演習：%1</translation>
    </message>
    <message>
        <source>Upper right</source>
        <translation>上顎右側</translation>
    </message>
    <message>
        <source>Upper left</source>
        <translation>上顎左側</translation>
    </message>
    <message>
        <source>Lower right</source>
        <translation>下顎右側</translation>
    </message>
    <message>
        <source>Lower left</source>
        <translation>下顎左側</translation>
    </message>
</context>
<context>
    <name>tactooth::ToothChartDialog</name>
    <message>
        <source>Tooth chart</source>
        <translation>歯列図</translation>
    </message>
    <message>
        <source>FDI (11 to 48)</source>
        <translation>FDI（11～48）</translation>
    </message>
    <message>
        <source>Universal (1 to 32)</source>
        <translation>ユニバーサル（1～32）</translation>
    </message>
    <message>
        <source>Palmer (1 to 8 with a corner)</source>
        <translation>パーマー（1～8と鉤形）</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>番号(&amp;N)</translation>
    </message>
    <message>
        <source>on the bench</source>
        <translation>作業中の歯</translation>
    </message>
    <message>
        <source>has an exercise</source>
        <translation>演習がある歯</translation>
    </message>
</context>
<context>
    <name>tactooth::ToothChartEntry</name>
    <message>
        <source>&amp;Tooth chart…</source>
        <translation>歯列図(&amp;T)…</translation>
    </message>
    <message>
        <source>Chooses a tooth of the whole mouth, with its neighbours and gums (%1)</source>
        <translation>口全体から歯を選びます。隣の歯と歯肉も一緒に読み込みます（%1）</translation>
    </message>
    <message>
        <source>Chooses a tooth of the whole mouth, with its neighbours and gums</source>
        <translation>口全体から歯を選びます。隣の歯と歯肉も一緒に読み込みます</translation>
    </message>
    <message>
        <source>Tooth chart</source>
        <translation>歯列図</translation>
    </message>
    <message>
        <source>Tooth %1</source>
        <translation>歯 %1</translation>
    </message>
</context>
<context>
    <name>tactooth::FinishController</name>
    <message>
        <source>The time goes on.</source>
        <translation>時間の計測を続けます。</translation>
    </message>
    <message>
        <source>The time stands still. The work is being assessed…</source>
        <translation>時間を止めました。評価しています…</translation>
    </message>
    <message>
        <source>The examination is over.</source>
        <translation>試験は終わりました。</translation>
    </message>
    <message>
        <source>The examination is over: its recording is signed and closed. Hand in your work.</source>
        <translation>試験は終わりました。記録には署名が付き、閉じられました。作業を提出してください。</translation>
    </message>
    <message>
        <source>The report, the tooth and the recording of this work are written into a new folder. Nothing is sent anywhere.</source>
        <translation>この作業の報告書、歯、記録を新しいフォルダーに書き出します。どこにも送信されません。</translation>
    </message>
    <message>
        <source>Finished: the time stands still.</source>
        <translation>終了：時間は止まっています。</translation>
    </message>
    <message>
        <source>The time stands still until you choose Continue, or Cut.</source>
        <translation>「続ける」か「切削」を選ぶまで、時間は止まっています。</translation>
    </message>
    <message>
        <source>Handed in: %1</source>
        <translation>提出しました：%1</translation>
    </message>
    <message>
        <source>Hand in</source>
        <translation>提出</translation>
    </message>
    <message>
        <source>Choose an exercise first: without one there is nothing to compare the work with</source>
        <translation>先に課題を選んでください。課題がないと、作業を比べる相手がありません</translation>
    </message>
    <message>
        <source>The work is being assessed</source>
        <translation>作業を評価しています</translation>
    </message>
    <message>
        <source>Something else is shown in place of the tooth</source>
        <translation>歯の代わりに別のものが表示されています</translation>
    </message>
    <message>
        <source>The tooth is not ready yet</source>
        <translation>歯の準備がまだできていません</translation>
    </message>
    <message>
        <source>Assessing</source>
        <translation>評価中</translation>
    </message>
    <message>
        <source>The work goes on as if you had not finished it</source>
        <translation>終了しなかったものとして作業を続けます</translation>
    </message>
</context>
<context>
    <name>tactooth::ReportDialog</name>
    <message>
        <source>limit, %1</source>
        <translation>上限、%1</translation>
    </message>
    <message>
        <source>not measurable</source>
        <translation>測れません</translation>
    </message>
    <message>
        <source>Score %1 of 100</source>
        <translation>得点 %1 / 100</translation>
    </message>
    <message>
        <source>The mark is no better because of this.</source>
        <translation>この項目のため、評点はこれより良くなりません。</translation>
    </message>
    <message>
        <source>Report: %1</source>
        <translation>報告書：%1</translation>
    </message>
    <message>
        <source>Smaller pages</source>
        <translation>ページを縮小</translation>
    </message>
    <message>
        <source>Larger pages</source>
        <translation>ページを拡大</translation>
    </message>
    <message>
        <source>Fit width</source>
        <translation>幅に合わせる</translation>
    </message>
    <message>
        <source>Pages as wide as the view</source>
        <translation>ページを表示の幅に合わせます</translation>
    </message>
    <message>
        <source>Mark of 100</source>
        <translation>評点（100 点満点）</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>合格</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>不合格</translation>
    </message>
    <message>
        <source>of 100; pass mark %1</source>
        <translation>100 点満点、合格点 %1</translation>
    </message>
    <message>
        <source>What the mark is made of</source>
        <translation>評点の内訳</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>減点</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>評価項目</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>測定値</translation>
    </message>
    <message>
        <source>Where, when</source>
        <translation>場所、時刻</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>次にすること</translation>
    </message>
    <message>
        <source>&amp;Again</source>
        <translation>もう一度(&amp;A)</translation>
    </message>
    <message>
        <source>The same exercise from the start</source>
        <translation>同じ課題を最初から行います</translation>
    </message>
    <message>
        <source>&amp;Replay the error</source>
        <translation>誤りを再生(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Hand in…</source>
        <translation>提出(&amp;H)…</translation>
    </message>
    <message>
        <source>Writes the report, the tooth and the recording into a folder; nothing is sent</source>
        <translation>報告書、歯、記録をフォルダーに書き出します。何も送信されません</translation>
    </message>
    <message>
        <source>&amp;Continue</source>
        <translation>続ける(&amp;C)</translation>
    </message>
    <message>
        <source>Goes on with the work, and so does the time</source>
        <translation>作業と時間の計測を続けます</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>閉じる(&amp;L)</translation>
    </message>
    <message>
        <source>Leads back to the tooth; the time stands still until you choose Continue</source>
        <translation>歯に戻ります。「続ける」を選ぶまで、時間は止まっています</translation>
    </message>
    <message>
        <source>Shows the recording of this work, from shortly before the error on</source>
        <translation>この作業の記録を、誤りの少し前から見せます</translation>
    </message>
    <message>
        <source>There is no recording of this work: see Recordings in the menu File</source>
        <translation>この作業の記録はありません。「ファイル」メニューの「記録」を見てください</translation>
    </message>
    <message>
        <source>This criterion has no single moment: choose one with a time</source>
        <translation>この項目には決まった時刻がありません。時刻のある項目を選んでください</translation>
    </message>
    <message>
        <source>Handed in: %1</source>
        <translation>提出しました：%1</translation>
    </message>
</context>
<context>
    <name>tactooth::ReportPagesView</name>
    <message>
        <source>Pages of the report</source>
        <translation>報告書のページ</translation>
    </message>
</context>
<context>
    <name>tactooth::HandInDialog</name>
    <message>
        <source>&amp;Browse…</source>
        <translation>参照(&amp;B)…</translation>
    </message>
    <message>
        <source>&amp;Hand in</source>
        <translation>提出(&amp;H)</translation>
    </message>
    <message>
        <source>Hand in</source>
        <translation>提出</translation>
    </message>
    <message>
        <source>&amp;Name of the student</source>
        <translation>学生の氏名(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Comment of the teacher</source>
        <translation>教員のコメント(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;In the folder</source>
        <translation>保存先フォルダー(&amp;I)</translation>
    </message>
    <message>
        <source>Folder of what is handed in</source>
        <translation>提出するもののフォルダー</translation>
    </message>
</context>
<context>
    <name>tactooth::InstrumentTray</name>
    <message>
        <source>Instruments</source>
        <translation>器具</translation>
    </message>
    <message>
        <source>Turbine</source>
        <translation>タービン</translation>
    </message>
    <message>
        <source>Contra-angle</source>
        <translation>コントラ</translation>
    </message>
    <message>
        <source>Low speed</source>
        <translation>低速</translation>
    </message>
    <message>
        <source>Explorer (%1): touches; its tip sticks in soft decay</source>
        <translation>探針（%1）：触れる。軟らかいう蝕に先端が刺さる</translation>
    </message>
    <message>
        <source>Periodontal probe (%1): reads how deep its tip stands</source>
        <translation>歯周プローブ（%1）：先端の深さを測る</translation>
    </message>
    <message>
        <source>Spoon excavator (%1): takes soft decay by hand</source>
        <translation>スプーンエキスカベーター（%1）：軟らかいう蝕を手で取る</translation>
    </message>
    <message>
        <source>Explorer</source>
        <translation>探針</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>プローブ</translation>
    </message>
    <message>
        <source>Excavator</source>
        <translation>エキスカ</translation>
    </message>
</context>
</TS>
