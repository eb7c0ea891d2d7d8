<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP" sourcelanguage="en">
<context>
    <name>Words</name>
    <message>
        <source>Lower first molar (46)</source>
        <translation>下顎第一大臼歯（46）</translation>
    </message>
    <message>
        <source>Upper central incisor (11)</source>
        <translation>上顎中切歯（11）</translation>
    </message>
    <message>
        <source>Upper canine (13)</source>
        <translation>上顎犬歯（13）</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>ラウンド</translation>
    </message>
    <message>
        <source>Inverted cone</source>
        <translation>インバーテッドコーン</translation>
    </message>
    <message>
        <source>Pear</source>
        <translation>ペアーシェイプ</translation>
    </message>
    <message>
        <source>Long pear</source>
        <translation>ロングペアーシェイプ</translation>
    </message>
    <message>
        <source>Straight fissure</source>
        <translation>ストレートフィッシャー</translation>
    </message>
    <message>
        <source>Cross-cut straight fissure</source>
        <translation>クロスカットストレートフィッシャー</translation>
    </message>
    <message>
        <source>Dome-end fissure</source>
        <translation>ドームエンドフィッシャー</translation>
    </message>
    <message>
        <source>Tapered fissure</source>
        <translation>テーパードフィッシャー</translation>
    </message>
    <message>
        <source>Cross-cut tapered fissure</source>
        <translation>クロスカットテーパードフィッシャー</translation>
    </message>
    <message>
        <source>Long tapered fissure</source>
        <translation>ロングテーパードフィッシャー</translation>
    </message>
    <message>
        <source>Round-end tapered fissure</source>
        <translation>ラウンドエンドテーパードフィッシャー</translation>
    </message>
    <message>
        <source>Dome-end tapered fissure</source>
        <translation>ドームエンドテーパードフィッシャー</translation>
    </message>
    <message>
        <source>Ball finishing</source>
        <translation>ボール仕上げ用</translation>
    </message>
    <message>
        <source>Egg finishing</source>
        <translation>エッグ仕上げ用</translation>
    </message>
    <message>
        <source>Needle finishing</source>
        <translation>ニードル仕上げ用</translation>
    </message>
    <message>
        <source>Football</source>
        <translation>フットボール</translation>
    </message>
    <message>
        <source>Flat-end cylinder</source>
        <translation>フラットエンドシリンダー</translation>
    </message>
    <message>
        <source>Flat-end taper</source>
        <translation>フラットエンドテーパー</translation>
    </message>
    <message>
        <source>Round-end taper</source>
        <translation>ラウンドエンドテーパー</translation>
    </message>
    <message>
        <source>Needle</source>
        <translation>ニードル</translation>
    </message>
    <message>
        <source>Flame</source>
        <translation>フレーム</translation>
    </message>
    <message>
        <source>Torpedo</source>
        <translation>トーピード</translation>
    </message>
    <message>
        <source>Torpedo taper</source>
        <translation>トーピードテーパー</translation>
    </message>
    <message>
        <source>Round-end cylinder</source>
        <translation>ラウンドエンドシリンダー</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>%1 carbide No. %2, %3</source>
        <translation>%1カーバイド No. %2、%3</translation>
    </message>
    <message>
        <source>%1 diamond %2, %3</source>
        <translation>%1ダイヤモンド %2、%3</translation>
    </message>
    <message>
        <source>Air turbine, 400,000 rev/min</source>
        <translation>エアタービン、400,000 回転/分</translation>
    </message>
    <message>
        <source>Electric 1:5, 200,000 rev/min</source>
        <translation>5倍速電動、200,000 回転/分</translation>
    </message>
    <message>
        <source>Low-speed contra-angle, 25,000 rev/min</source>
        <translation>低速コントラアングル、25,000 回転/分</translation>
    </message>
    <message>
        <source>en</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>sound starting</source>
        <translation>音を準備中</translation>
    </message>
    <message>
        <source>sound on</source>
        <translation>音あり</translation>
    </message>
    <message>
        <source>no sound card: silent</source>
        <translation>サウンドカードなし：無音</translation>
    </message>
    <message>
        <source>Mouse and keyboard</source>
        <translation>マウスとキーボード</translation>
    </message>
    <message>
        <source>Haptic pen (OpenHaptics)</source>
        <translation>力覚ペン（OpenHaptics）</translation>
    </message>
    <message>
        <source>Gamepad</source>
        <translation>ゲームパッド</translation>
    </message>
    <message>
        <source>SpaceMouse</source>
        <translation>SpaceMouse</translation>
    </message>
    <message>
        <source>Haply Inverse3</source>
        <translation>Haply Inverse3</translation>
    </message>
    <message>
        <source>outer</source>
        <translation>外表面</translation>
    </message>
    <message>
        <source>first contact</source>
        <translation>最初の接触</translation>
    </message>
    <message>
        <source>dentin reached</source>
        <translation>象牙質に到達</translation>
    </message>
    <message>
        <source>pulp exposed</source>
        <translation>歯髄が露出</translation>
    </message>
    <message>
        <source>neighbour touched</source>
        <translation>隣在歯に接触</translation>
    </message>
    <message>
        <source>gum or bone touched</source>
        <translation>歯肉または骨に接触</translation>
    </message>
    <message>
        <source>cut beside the tooth</source>
        <translation>対象の歯以外を切削</translation>
    </message>
    <message>
        <source>bur stalled</source>
        <translation>バーが停止</translation>
    </message>
    <message>
        <source>piece came loose</source>
        <translation>歯片が脱落</translation>
    </message>
    <message>
        <source>Pit in the molar</source>
        <translation>臼歯の小窩</translation>
    </message>
    <message>
        <source>Open the central pit 1.5 mm deep, as wide as the bur: down and up again without going aside.</source>
        <translation>中心小窩をバーの幅のまま深さ 1.5 mm まで開けます。横に動かさず、まっすぐ下ろして戻します。</translation>
    </message>
    <message>
        <source>Class I cavity in the molar</source>
        <translation>臼歯の 1 級窩洞</translation>
    </message>
    <message>
        <source>Follow the central fissure, 1.5 mm deep and 1.2 mm wide with a flat floor; leave 2 mm of both ridges.</source>
        <translation>中心溝に沿って深さ 1.5 mm、幅 1.2 mm、窩底を平らに削ります。両側の辺縁隆線は 2 mm 残します。</translation>
    </message>
    <message>
        <source>Class V cavity at the neck of the canine</source>
        <translation>犬歯歯頸部の 5 級窩洞</translation>
    </message>
    <message>
        <source>At the buccal neck, 1.1 mm deep everywhere: the floor follows the surface of the tooth.</source>
        <translation>唇側歯頸部を、どこも深さ 1.1 mm で削ります。窩底は歯面に沿わせます。</translation>
    </message>
</context>
<context>
    <name>Error</name>
    <message>
        <source>%1: Tactooth knows no device %2; the usual one takes its place, choose another in the panel Hand.</source>
        <translation>%1: 装置 %2 はありません。いつもの装置を使います。別の装置は「手」パネルで選べます。</translation>
    </message>
    <message>
        <source>%1: there is no line that names the columns; begin the file with %2.</source>
        <translation>%1: 列名の行がありません。ファイルの先頭に %2 と書いてください。</translation>
    </message>
    <message>
        <source>%1: there are no rows below the names of the columns; add at least one.</source>
        <translation>%1: 列名の下に行がありません。1 行以上追加してください。</translation>
    </message>
    <message>
        <source>the column &apos;%1&apos; is missing; expected the columns %2, separated by commas, but found %3</source>
        <translation>列 &apos;%1&apos; がありません。列 %2 をコンマで区切って並べてください。見つかったのは %3 です</translation>
    </message>
    <message>
        <source>a cell in quotes must end with its line, and nothing but a separator may follow it</source>
        <translation>引用符で囲んだセルは行の中で閉じ、そのあとには区切り文字だけを続けてください</translation>
    </message>
    <message>
        <source>the column &apos;%1&apos; is named twice; remove one of the two</source>
        <translation>列 &apos;%1&apos; が 2 回あります。どちらかを削除してください</translation>
    </message>
    <message>
        <source>expected %1 fields, one for each named column, but found %2</source>
        <translation>列名と同じ %1 個の項目が必要ですが、%2 個あります</translation>
    </message>
    <message>
        <source>column &apos;%1&apos;: expected a finite number with &apos;.&apos; as decimal point, but found %2</source>
        <translation>列 &apos;%1&apos;: 小数点に &apos;.&apos; を使った有限の数値が必要ですが、%2 があります</translation>
    </message>
    <message>
        <source>%1: the quaternion qw,qx,qy,qz must have length 1, but its length is %2; write 1,0,0,0 for a tool that is not turned.</source>
        <translation>%1: クォータニオン qw,qx,qy,qz の長さは 1 でなければなりませんが、%2 です。回転していない場合は 1,0,0,0 と書いてください。</translation>
    </message>
    <message>
        <source>%1: time runs backwards (t is less than in the row above); sort the rows by t.</source>
        <translation>%1: 時刻が逆戻りしています（t が上の行より小さい）。行を t の順に並べ替えてください。</translation>
    </message>
    <message>
        <source>%1 is broken, %2: install the device&apos;s driver anew; Tactooth leaves it alone.</source>
        <translation>%1 は壊れています（%2）。デバイスのドライバーを入れ直してください。Tactooth はこのライブラリを使いません。</translation>
    </message>
    <message>
        <source>it crashes (%1)</source>
        <translation>クラッシュします: %1</translation>
    </message>
    <message>
        <source>it does not return</source>
        <translation>応答が戻りません</translation>
    </message>
    <message>
        <source>it ends the program that uses it</source>
        <translation>呼び出したプログラムを終了させます</translation>
    </message>
    <message>
        <source>%1: there is no such file; check the name and the folder.</source>
        <translation>%1：ファイルがありません。名前とフォルダーを確かめてください。</translation>
    </message>
    <message>
        <source>%1: this user may not read the file; change its permissions.</source>
        <translation>%1：このユーザーにはファイルを読む権限がありません。アクセス権を変えてください。</translation>
    </message>
    <message>
        <source>%1: the file cannot be opened: %2.</source>
        <translation>%1：ファイルを開けません：%2。</translation>
    </message>
    <message>
        <source>%1: reading stopped: %2.</source>
        <translation>%1：読み込みが止まりました：%2。</translation>
    </message>
    <message>
        <source>%1: this is a folder; name a file inside it.</source>
        <translation>%1：これはフォルダーです。中のファイルを指定してください。</translation>
    </message>
    <message>
        <source>%1: this is not a regular file (a device or a pipe); name a file on disk.</source>
        <translation>%1：通常のファイルではありません（デバイスまたはパイプです）。ディスク上のファイルを指定してください。</translation>
    </message>
    <message>
        <source>%1: the file is empty; export or copy it again.</source>
        <translation>%1：ファイルが空です。書き出し直すか、コピーし直してください。</translation>
    </message>
    <message>
        <source>%1: the file (%2 bytes) does not fit into memory.</source>
        <translation>%1：ファイル（%2 バイト）がメモリーに収まりません。</translation>
    </message>
    <message>
        <source>%1 reaches %2 mm from its origin, farther than anything can be felt or cut (1 km): look for a stray corner, or check the unit</source>
        <translation>%1が原点から %2 mm 離れています。触れたり削ったりできる範囲（1 km）を超えています。はぐれた頂点がないか、単位が正しいかを確かめてください</translation>
    </message>
    <message>
        <source>the surface of %1</source>
        <translation>%1の表面</translation>
    </message>
    <message>
        <source>the surface</source>
        <translation>表面</translation>
    </message>
    <message>
        <source>%1: the file holds %2 bytes, and at most %3 are read of such a file; choose another or a smaller one.</source>
        <translation>%1：ファイルは %2 バイトありますが、この種のファイルは %3 バイトまでしか読み込めません。別のファイルか、小さいファイルを選んでください。</translation>
    </message>
    <message>
        <source>row %1 of the table has a number that is not finite, so nothing is written; check size and unit of the surfaces.</source>
        <translation>表の %1 行目に有限でない数値があるため、何も書き込みませんでした。表面の大きさと単位を確かめてください。</translation>
    </message>
    <message>
        <source>%1: the tool is farther than 10 m from the tooth&apos;s origin; x,y,z are in mm, so check the unit.</source>
        <translation>%1：器具が歯の原点から 10 m より遠くにあります。x,y,z の単位は mm です。単位を確かめてください。</translation>
    </message>
    <message>
        <source>%1: t is beyond any clock&apos;s seconds; t is in s, so check the unit.</source>
        <translation>%1：t が時計の秒として大きすぎます。t の単位は秒です。単位を確かめてください。</translation>
    </message>
    <message>
        <source>%1: cannot be written: its folder does not exist; make the folder first.</source>
        <translation>%1：書き込めません。フォルダーがありません。先にフォルダーを作ってください。</translation>
    </message>
    <message>
        <source>%1: cannot be written: this user may not write into its folder; choose another one.</source>
        <translation>%1：書き込めません。このユーザーにはフォルダーへ書き込む権限がありません。別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2.</source>
        <translation>%1：書き込めません：%2。</translation>
    </message>
    <message>
        <source>%1: cannot be written: this is a folder; name a file inside it.</source>
        <translation>%1：書き込めません。これはフォルダーです。中のファイルを指定してください。</translation>
    </message>
    <message>
        <source>%1: cannot be written: this is not a regular file; choose another name.</source>
        <translation>%1：書き込めません。通常のファイルではありません。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>the plot %1 could not be drawn: it does not fit into memory.</source>
        <translation>グラフ %1 を描けませんでした：メモリーに入りきりません。</translation>
    </message>
    <message>
        <source>the plots cannot be written to %1: end its name in .csv, .svg or .png.</source>
        <translation>グラフを %1 に書き込めません。名前の最後を .csv、.svg、.png のいずれかにしてください。</translation>
    </message>
    <message>
        <source>%1: the folder cannot be read (%2).</source>
        <translation>%1：フォルダーを読めません（%2）。</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made (%2).</source>
        <translation>%1：フォルダーを作れません（%2）。</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>ファイルが大きすぎます</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>ディスクの割り当て容量を超えました</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>ディスクの空き容量がありません</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>アクセス権がありません</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>読み取り専用のディスクです</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>入出力エラー</translation>
    </message>
    <message>
        <source>%1: %2 files cannot be read; export the surface as STL, OBJ or PLY.</source>
        <translation>%1：%2 ファイルは読めません。表面を STL、OBJ、PLY のいずれかで書き出してください。</translation>
    </message>
    <message>
        <source>%1: the file holds no triangles; export the surface again.</source>
        <translation>%1：ファイルに三角形がありません。表面を書き出し直してください。</translation>
    </message>
    <message>
        <source>%1: the file holds no faces; export the surface again, as triangles.</source>
        <translation>%1：ファイルに面がありません。表面を三角形で書き出し直してください。</translation>
    </message>
    <message>
        <source>%1: the surface lies too far from zero for single precision, in which its place is needed; move it near to zero, or make a case of it with &apos;tactooth case new&apos;.</source>
        <translation>%1：表面が原点から遠すぎて、位置を単精度で表せません。原点の近くに移すか、&apos;tactooth case new&apos; で症例にしてください。</translation>
    </message>
    <message>
        <source>%1: this is text in UTF-16; save it as UTF-8.</source>
        <translation>%1：これは UTF-16 のテキストです。UTF-8 で保存してください。</translation>
    </message>
    <message>
        <source>%1: triangle %2 (byte %3) has a corner that is not a finite number; repair or export the surface again.</source>
        <translation>%1：三角形 %2（%3 バイト目）の頂点が有限の数値ではありません。表面を修復するか、書き出し直してください。</translation>
    </message>
    <message>
        <source>%1: this is %2, not an STL surface; export the surface as STL.</source>
        <translation>%1：これは%2で、STL の表面ではありません。表面を STL で書き出してください。</translation>
    </message>
    <message>
        <source>a PLY mesh</source>
        <translation>PLY メッシュ</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>ZIP アーカイブ</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation>gzip アーカイブ</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>PNG 画像</translation>
    </message>
    <message>
        <source>an OFF mesh</source>
        <translation>OFF メッシュ</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>JPEG 画像</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>PDF 文書</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>プログラム</translation>
    </message>
    <message>
        <source>a DICOM image</source>
        <translation>DICOM 画像</translation>
    </message>
    <message>
        <source>a Mac&apos;s notes on a file of this name</source>
        <translation>この名前のファイルについての Mac の覚え書き</translation>
    </message>
    <message>
        <source>text that does not begin with &apos;solid&apos;</source>
        <translation>&apos;solid&apos; で始まらないテキスト</translation>
    </message>
    <message>
        <source>unknown binary data</source>
        <translation>不明なバイナリデータ</translation>
    </message>
    <message>
        <source>%1: its header announces %2 triangles, which take %3 bytes, but the file has %4; export or copy it again.</source>
        <translation>%1：ヘッダーによれば三角形は %2 個、大きさは %3 バイトですが、ファイルは %4 バイトです。書き出し直すか、コピーし直してください。</translation>
    </message>
    <message>
        <source>the file is cut short or its count is wrong</source>
        <translation>ファイルが途中で切れているか、個数が誤っています</translation>
    </message>
    <message>
        <source>the file is longer than its triangle count says</source>
        <translation>ファイルが三角形の個数に対して長すぎます</translation>
    </message>
    <message>
        <source>%1: the file is too short for an STL surface: it has %2 bytes and a binary one needs at least %3; export or copy it again.</source>
        <translation>%1：STL の表面としてはファイルが短すぎます。バイナリー形式には少なくとも %3 バイトが必要ですが、%2 バイトしかありません。書き出し直すか、コピーし直してください。</translation>
    </message>
    <message>
        <source>%1, line %2: %3, but %4; repair or export the surface again.</source>
        <translation>%1、%2 行目：%3。%4。表面を修復するか、書き出し直してください。</translation>
    </message>
    <message>
        <source>expected &apos;solid&apos; or the end of the file</source>
        <translation>&apos;solid&apos; またはファイルの終わりが必要です</translation>
    </message>
    <message>
        <source>expected &apos;facet&apos; or &apos;endsolid&apos;</source>
        <translation>&apos;facet&apos; または &apos;endsolid&apos; が必要です</translation>
    </message>
    <message>
        <source>expected the facet&apos;s normal</source>
        <translation>面の法線が必要です</translation>
    </message>
    <message>
        <source>expected a coordinate (a number with &apos;.&apos; as decimal point)</source>
        <translation>座標（小数点に &apos;.&apos; を使った数値）が必要です</translation>
    </message>
    <message>
        <source>expected a finite coordinate</source>
        <translation>有限の座標が必要です</translation>
    </message>
    <message>
        <source>expected &apos;%1&apos;</source>
        <translation>&apos;%1&apos; が必要です</translation>
    </message>
    <message>
        <source>found %1</source>
        <translation>見つかったのは %1 です</translation>
    </message>
    <message>
        <source>the file ends: it is cut short</source>
        <translation>ファイルが途中で切れています</translation>
    </message>
    <message>
        <source>%1, line %2: %3; repair or export the surface again.</source>
        <translation>%1、%2 行目：%3。表面を修復するか、書き出し直してください。</translation>
    </message>
    <message>
        <source>expected a finite coordinate, but found %1</source>
        <translation>有限の座標が必要ですが、見つかったのは %1 です</translation>
    </message>
    <message>
        <source>expected the number of a vertex that the file has given above, but found %1</source>
        <translation>それまでに出てきた頂点の番号が必要ですが、見つかったのは %1 です</translation>
    </message>
    <message>
        <source>expected a face of three corners or more</source>
        <translation>三つ以上の頂点を持つ面が必要です</translation>
    </message>
    <message>
        <source>%1: the PLY header names no format; export the surface again.</source>
        <translation>%1：PLY のヘッダーに形式が書かれていません。表面を書き出し直してください。</translation>
    </message>
    <message>
        <source>%1, line %2: expected a line of a PLY header, but found %3; export the surface again.</source>
        <translation>%1、%2 行目：PLY のヘッダーの行が必要ですが、見つかったのは %3 です。表面を書き出し直してください。</translation>
    </message>
    <message>
        <source>%1: the PLY header has no end: the file is cut short; export the surface again.</source>
        <translation>%1：PLY のヘッダーに終わりがありません。ファイルが途中で切れています。表面を書き出し直してください。</translation>
    </message>
    <message>
        <source>%1: %2; export the surface again.</source>
        <translation>%1：%2。表面を書き出し直してください。</translation>
    </message>
    <message>
        <source>the file holds no faces</source>
        <translation>ファイルに面がありません</translation>
    </message>
    <message>
        <source>the outline of the face crosses itself</source>
        <translation>面の輪郭が自分自身と交わっています</translation>
    </message>
    <message>
        <source>the face has too many corners to be split into triangles</source>
        <translation>面の頂点が多すぎて三角形に分けられません</translation>
    </message>
    <message>
        <source>the file is cut short, or holds what is no number</source>
        <translation>ファイルが途中で切れているか、数値でないものが入っています</translation>
    </message>
    <message>
        <source>x, y and z are not three finite numbers</source>
        <translation>x、y、z が三つの有限の数値ではありません</translation>
    </message>
    <message>
        <source>the file is cut short</source>
        <translation>ファイルが途中で切れています</translation>
    </message>
    <message>
        <source>a list is longer than the file</source>
        <translation>リストがファイルより長くなっています</translation>
    </message>
    <message>
        <source>a corner names a vertex that the file does not have</source>
        <translation>面の頂点がファイルにない頂点を指しています</translation>
    </message>
    <message>
        <source>%1: the tooth has this surface already; drop the files of one tooth, its layers named as in L6_enamel.stl.</source>
        <translation>%1：この表面はすでにあります。1本の歯のファイルだけをドロップし、層には L6_enamel.stl のように名前を付けてください。</translation>
    </message>
    <message>
        <source>%1: there is no surface.</source>
        <translation>%1：表面がありません。</translation>
    </message>
    <message>
        <source>the layers give no closed surface together; give the tooth&apos;s outer surface as a file, too</source>
        <translation>層を合わせても閉じた表面になりません。歯の外表面のファイルも加えてください</translation>
    </message>
    <message>
        <source>%1: the surface &apos;%2&apos; has %3 holes that are too wide to be filled unasked (%4 open edges); ask for all holes to be filled, or close it in a mesh program.</source>
        <translation>%1：表面 &apos;%2&apos; に、自動でふさぐには大きすぎる穴が %3 個あります（開いた辺 %4 本）。「すべての穴をふさぐ」を選ぶか、メッシュ編集ソフトで閉じてください。</translation>
    </message>
    <message>
        <source>the surface of %1 holds no triangle: give a closed STL surface</source>
        <translation>%1の表面に三角形がありません。閉じた STL の表面を使ってください</translation>
    </message>
    <message>
        <source>the surface of %1 is open (%2 edges without a neighbour), so it has no inside to cut: close its holes first</source>
        <translation>%1の表面が閉じておらず（隣のない辺 %2 本）、削る内部がありません。先に穴をふさいでください</translation>
    </message>
    <message>
        <source>%1 is open (%2 edges without a neighbour), so it has no inside: close its holes first</source>
        <translation>%1が閉じておらず（隣のない辺 %2 本）、内部がありません。先に穴をふさいでください</translation>
    </message>
    <message>
        <source>%1 holds no room: give a closed surface with triangles that have an area</source>
        <translation>%1は体積がありません。面積のある三角形からなる閉じた表面を指定してください</translation>
    </message>
    <message>
        <source>%1 is twisted: it has no outside; mend it in a mesh program</source>
        <translation>%1はねじれていて外側がありません。メッシュ編集ソフトで修復してください</translation>
    </message>
    <message>
        <source>%1 has parts that reach into each other by %2 mm (%3 triangles cross), so what is inside is unclear: unite them in a mesh program</source>
        <translation>%1に互いに %2 mm 入り込んだ部分があり（交差する三角形 %3 個）、どこが内部か決まりません。メッシュ編集ソフトで一つに統合してください</translation>
    </message>
    <message>
        <source>%1 bounds no body: its triangles cross each other nearly everywhere; export it again</source>
        <translation>%1は立体を囲んでいません。三角形がほぼ全体で互いに交差しています。書き出し直してください</translation>
    </message>
    <message>
        <source>the surface &apos;%1&apos;</source>
        <translation>表面 &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the ideal shape, the whole tooth with its cavity,</source>
        <translation>理想形状（窩洞を含む歯全体）</translation>
    </message>
    <message>
        <source>%1: the surface &apos;%2&apos; cannot be closed (%3 open edges): walls meet inside it, or pieces hang together with nothing; close it in a mesh program.</source>
        <translation>%1：表面 &apos;%2&apos; を閉じられません（開いた辺 %3 本）。内部で壁が交わっているか、どこにもつながらない断片があります。メッシュ編集ソフトで閉じてください。</translation>
    </message>
    <message>
        <source>%1: the surface &apos;%2&apos; crosses itself by %3 mm once its %4 holes are filled; close it in a mesh program.</source>
        <translation>%1：表面 &apos;%2&apos; は %4 個の穴をふさぐと %3 mm 自己交差します。メッシュ編集ソフトで閉じてください。</translation>
    </message>
    <message>
        <source>the surface of %1 is inside out (its normals point inward): reverse the order of its triangles&apos; corners</source>
        <translation>%1の表面が裏返しです（法線が内側を向いています）。三角形の頂点の順序を逆にしてください</translation>
    </message>
    <message>
        <source>%1 lies outside the tooth: give all layers in the frame of the outer surface</source>
        <translation>%1が歯の外側にあります。すべての層を外表面と同じ座標系にしてください</translation>
    </message>
    <message>
        <source>%1 is given twice: give each layer of a tooth its own name</source>
        <translation>%1が二つあります。歯の層にはそれぞれ別の名前を付けてください</translation>
    </message>
    <message>
        <source>layer &apos;%1&apos;</source>
        <translation>層「%1」</translation>
    </message>
    <message>
        <source>the tooth</source>
        <translation>歯</translation>
    </message>
    <message>
        <source>the tool&apos;s surface has no extent along its axis (z of the tool frame): give the bur&apos;s closed STL with its tip at the origin and its shaft along +z</source>
        <translation>バーの表面に軸方向（工具の座標系の z）の長さがありません。先端を原点、軸を +z に合わせた、閉じた STL を使ってください</translation>
    </message>
    <message>
        <source>%1, byte %2: %3</source>
        <translation>%1、%2 バイト目：%3</translation>
    </message>
    <message>
        <source>the file is cut short; save the tooth again or use a complete copy.</source>
        <translation>ファイルが途中で切れています。歯を保存し直すか、完全なコピーを使ってください。</translation>
    </message>
    <message>
        <source>this is no saved tooth; choose a file that Tactooth has saved.</source>
        <translation>保存された歯ではありません。Tactooth で保存したファイルを選んでください。</translation>
    </message>
    <message>
        <source>the file has format version %1, and this program reads versions 1 to 3; open it with the program that saved it.</source>
        <translation>ファイルの形式はバージョン %1 ですが、このプログラムが読めるのはバージョン 1 から 3 です。保存したプログラムで開いてください。</translation>
    </message>
    <message>
        <source>there is more in the file than the tooth; use an undamaged copy.</source>
        <translation>ファイルに歯以外のデータが入っています。壊れていないコピーを使ってください。</translation>
    </message>
    <message>
        <source>the file is damaged; use another copy of it.</source>
        <translation>ファイルが壊れています。別のコピーを使ってください。</translation>
    </message>
    <message>
        <source>%1: a saved tooth has its own layers; give no others.</source>
        <translation>%1：保存した歯には層が含まれています。他の層は加えないでください。</translation>
    </message>
    <message>
        <source>%1: a saved tooth keeps the spacing that it was cut with, %2 um; give no other.</source>
        <translation>%1：保存した歯は、削ったときの格子間隔 %2 µm のままです。別の間隔は指定しないでください。</translation>
    </message>
    <message>
        <source>%1 crosses itself at each of the %2 finenesses that were tried; ask for another number of triangles or another seed.</source>
        <translation>%1は、試した %2 通りの細かさのいずれでも自分自身と交差します。三角形の数かシードを変えてください。</translation>
    </message>
    <message>
        <source>%1 gum of the mouth with seed %2 and %3 triangles a tooth</source>
        <translation>%1の歯肉（シード %2、1歯あたり三角形 %3 個）</translation>
    </message>
    <message>
        <source>The upper</source>
        <translation>上顎</translation>
    </message>
    <message>
        <source>The lower</source>
        <translation>下顎</translation>
    </message>
    <message>
        <source>%1 claims to hold %2 bytes, more than the %3 that a case may; it is damaged or not meant well.</source>
        <translation>%1 は %2 バイトとなっていて、症例の上限 %3 バイトを超えています。壊れているか、悪意のあるファイルです。</translation>
    </message>
    <message>
        <source>%1: the folder holds more than %2 files; give a case a folder of its own.</source>
        <translation>%1：フォルダーに %2 個を超えるファイルがあります。症例には専用のフォルダーを使ってください。</translation>
    </message>
    <message>
        <source>%1: the archive holds a file named &apos;%2&apos;, which points out of it; it is not meant well.</source>
        <translation>%1：アーカイブの外を指すファイル &apos;%2&apos; が入っています。悪意のあるファイルです。</translation>
    </message>
    <message>
        <source>%1: the archive holds a file named &apos;%2&apos;, which has control characters in its name; give it another one and pack anew.</source>
        <translation>%1：アーカイブの中のファイル &apos;%2&apos; の名前に制御文字があります。別の名前にして、もう一度まとめてください。</translation>
    </message>
    <message>
        <source>%1: the archive holds a file named &apos;%2&apos;, whose name is longer than 1000 bytes; give it a shorter one and pack anew.</source>
        <translation>%1：アーカイブの中のファイル &apos;%2&apos; の名前が 1000 バイトを超えています。短い名前にして、もう一度まとめてください。</translation>
    </message>
    <message>
        <source>%1: the archive holds several cases, in %2 and %3; pack each on its own.</source>
        <translation>%1：アーカイブに %2 と %3 など複数の症例が入っています。一つずつ別々にまとめてください。</translation>
    </message>
    <message>
        <source>%1: the archive holds two files of the same name; pack it anew.</source>
        <translation>%1：アーカイブに同じ名前のファイルが二つあります。作り直してください。</translation>
    </message>
    <message>
        <source>%1: there is no such file in the case.</source>
        <translation>%1：症例にこのファイルはありません。</translation>
    </message>
    <message>
        <source>%1: the link leads out of the case&apos;s folder; put a copy there instead.</source>
        <translation>%1：リンクが症例のフォルダーの外を指しています。代わりにコピーを置いてください。</translation>
    </message>
    <message>
        <source>%1: a case has its own layers; give no others.</source>
        <translation>%1：症例には層が含まれています。他の層は加えないでください。</translation>
    </message>
    <message>
        <source>%1: this is one tooth; a tooth can be chosen in a case only.</source>
        <translation>%1：これは1本の歯です。歯を選べるのは症例だけです。</translation>
    </message>
    <message>
        <source>%1: there is something already; give a new folder, or a name that ends in %2.</source>
        <translation>%1：すでに何かあります。新しいフォルダーか、%2 で終わる名前を指定してください。</translation>
    </message>
    <message>
        <source>%1: there is no tooth &apos;%2&apos; in this case; it has %3.</source>
        <translation>%1：この症例に歯 &apos;%2&apos; はありません。あるのは %3 です。</translation>
    </message>
    <message>
        <source>%1: the archive&apos;s list is damaged.</source>
        <translation>%1：アーカイブの一覧が壊れています。</translation>
    </message>
    <message>
        <source>%1: the file is locked with a password; pack the case without one.</source>
        <translation>%1：ファイルにパスワードがかかっています。パスワードなしで症例を作り直してください。</translation>
    </message>
    <message>
        <source>%1: the file is packed in an unusual way; pack the case with &apos;tactooth case pack&apos;.</source>
        <translation>%1：ファイルの圧縮方式が特殊です。&apos;tactooth case pack&apos; で症例を作り直してください。</translation>
    </message>
    <message>
        <source>%1: the file claims to unpack from %2 to %3 bytes, more than any surface does; the archive is damaged or not meant well.</source>
        <translation>%1：%2 バイトから %3 バイトに展開されることになっていますが、どんな表面もこれほど大きくなりません。アーカイブが壊れているか、悪意のあるファイルです。</translation>
    </message>
    <message>
        <source>%1: this is no zip archive that can be read (%2).</source>
        <translation>%1：読み込める ZIP アーカイブではありません（%2）。</translation>
    </message>
    <message>
        <source>%1: the archive holds %2 files, more than the %3 that a case may.</source>
        <translation>%1：アーカイブに %2 個のファイルがあり、症例の上限 %3 個を超えています。</translation>
    </message>
    <message>
        <source>%1: the archive claims to hold %2 bytes, more than the %3 that a case may.</source>
        <translation>%1：アーカイブの中身は %2 バイトとなっていて、症例の上限 %3 バイトを超えています。</translation>
    </message>
    <message>
        <source>%1: there is no such file in the archive.</source>
        <translation>%1：アーカイブにこのファイルはありません。</translation>
    </message>
    <message>
        <source>%1: the file is damaged inside the archive.</source>
        <translation>%1：アーカイブ内のファイルが壊れています。</translation>
    </message>
    <message>
        <source>%1: the file is not what the archive&apos;s list says; it is damaged.</source>
        <translation>%1：ファイルがアーカイブの一覧と一致しません。壊れています。</translation>
    </message>
    <message>
        <source>the case could not be packed: there is not enough memory.</source>
        <translation>症例を作れませんでした。メモリーが足りません。</translation>
    </message>
    <message>
        <source>%1, line %2: %3.</source>
        <translation>%1、%2 行目：%3。</translation>
    </message>
    <message>
        <source>this is not TOML: %1</source>
        <translation>TOML の書式ではありません：%1</translation>
    </message>
    <message>
        <source>%1: the file is too large: a TOML file may have %2 bytes at most.</source>
        <translation>%1：ファイルが大きすぎます。TOML ファイルは %2 バイトまでです。</translation>
    </message>
    <message>
        <source>the line is longer than %1 bytes; break it up</source>
        <translation>この行は %1 バイトを超えています。複数の行に分けてください</translation>
    </message>
    <message>
        <source>brackets stand more than %1 deep in each other; write it flatter</source>
        <translation>括弧の入れ子が %1 段を超えています。入れ子を浅くしてください</translation>
    </message>
    <message>
        <source>a key has more than %1 parts with dots between them; write a shorter one</source>
        <translation>点で区切られたキーの要素が %1 個を超えています。短いキーにしてください</translation>
    </message>
    <message>
        <source>there are more than %1 values; keep to what is asked for</source>
        <translation>値が %1 個を超えています。必要なものだけにしてください</translation>
    </message>
    <message>
        <source>%1 has no key %2; the keys are %3</source>
        <translation>%1に %2 というキーはありません。使えるキーは %3 です</translation>
    </message>
    <message>
        <source>a case</source>
        <translation>症例</translation>
    </message>
    <message>
        <source>a bur</source>
        <translation>バー</translation>
    </message>
    <message>
        <source>a tooth</source>
        <translation>歯</translation>
    </message>
    <message>
        <source>a body around the teeth</source>
        <translation>歯の周囲の物体</translation>
    </message>
    <message>
        <source>an exercise</source>
        <translation>課題</translation>
    </message>
    <message>
        <source>a cavity</source>
        <translation>窩洞</translation>
    </message>
    <message>
        <source>a stroke</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>a material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>a recording</source>
        <translation>録音</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; is missing</source>
        <translation>キー &apos;%1&apos; がありません</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; is missing; this version writes 1</source>
        <translation>キー &apos;%1&apos; がありません。このバージョンでは 1 を書きます</translation>
    </message>
    <message>
        <source>%1 must be a text of one line in quotes</source>
        <translation>%1 は引用符で囲んだ1行の文字列でなければなりません</translation>
    </message>
    <message>
        <source>the key &apos;%1&apos; is empty</source>
        <translation>キー &apos;%1&apos; が空です</translation>
    </message>
    <message>
        <source>%1 must be a list of texts</source>
        <translation>%1 は文字列のリストでなければなりません</translation>
    </message>
    <message>
        <source>%1 must be a list of texts of one line in quotes</source>
        <translation>%1 は引用符で囲んだ1行の文字列のリストでなければなりません</translation>
    </message>
    <message>
        <source>%1 must be a list of %2 numbers</source>
        <translation>%1 は %2 個の数値のリストでなければなりません</translation>
    </message>
    <message>
        <source>%1 must be a number from %2 to %3</source>
        <translation>%1 は %2 から %3 までの数値でなければなりません</translation>
    </message>
    <message>
        <source>%1 must be a number from %2 to %3, but is %4</source>
        <translation>%1 は %2 から %3 までの数値でなければなりません（実際の値：%4）</translation>
    </message>
    <message>
        <source>%1 must be a whole number from %2 to %3, but is %4</source>
        <translation>%1 は %2 から %3 までの整数でなければなりません（実際の値：%4）</translation>
    </message>
    <message>
        <source>%1 must be true or false</source>
        <translation>%1 は true か false でなければなりません</translation>
    </message>
    <message>
        <source>%1 must be a list of names and values in braces</source>
        <translation>%1 は波括弧で囲んだ名前と値の並びでなければなりません</translation>
    </message>
    <message>
        <source>&apos;%1&apos; must be %2</source>
        <translation>&apos;%1&apos; の値が誤っています。必要な値：%2</translation>
    </message>
    <message>
        <source>a number from 0 to %1</source>
        <translation>0 から %1 までの数値</translation>
    </message>
    <message>
        <source>a text in quotes</source>
        <translation>引用符で囲んだ文字列</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true か false</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>a list of %1</source>
        <translation>要素 %1 個のリスト</translation>
    </message>
    <message>
        <source>a table</source>
        <translation>テーブル</translation>
    </message>
    <message>
        <source>a date or a time</source>
        <translation>日付または時刻</translation>
    </message>
    <message>
        <source>not a finite number</source>
        <translation>有限でない数値</translation>
    </message>
    <message>
        <source>begin each %1 with a line [[%2]]</source>
        <translation>%1 はそれぞれ [[%2]] の行で始めてください</translation>
    </message>
    <message>
        <source>the case has format %1, which is newer than this program (1); take a newer one</source>
        <translation>症例の形式 %1 はこのプログラムの形式（1）より新しいものです。新しいプログラムを使ってください</translation>
    </message>
    <message>
        <source>there is no [[tooth]]</source>
        <translation>[[tooth]] がありません</translation>
    </message>
    <message>
        <source>there are too many teeth</source>
        <translation>歯が多すぎます</translation>
    </message>
    <message>
        <source>nobody could open this case: %1</source>
        <translation>この症例は誰にも開けません：%1</translation>
    </message>
    <message>
        <source>%1 is no permanent tooth; FDI numbers are 11-18, 21-28, 31-38 and 41-48</source>
        <translation>%1 は永久歯ではありません。FDI の番号は 11～18、21～28、31～38、41～48 です</translation>
    </message>
    <message>
        <source>the name must be short and without slashes</source>
        <translation>名前は短くし、スラッシュを使わないでください</translation>
    </message>
    <message>
        <source>the name %1 is given twice</source>
        <translation>名前 %1 が二つあります</translation>
    </message>
    <message>
        <source>%1 points out of the case; give a path inside its folder, with &apos;/&apos; and without &apos;..&apos;</source>
        <translation>%1 は症例の外を指しています。&apos;/&apos; を使い、&apos;..&apos; を使わずに、フォルダー内のパスを書いてください</translation>
    </message>
    <message>
        <source>%1 has control characters in its name; give the file another one</source>
        <translation>%1 の名前に制御文字があります。ファイルの名前を変えてください</translation>
    </message>
    <message>
        <source>%1 is longer than 1000 bytes; give the file a shorter name</source>
        <translation>%1 は 1000 バイトを超えています。ファイルの名前を短くしてください</translation>
    </message>
    <message>
        <source>%1 names no file; give a path inside the case&apos;s folder</source>
        <translation>%1 はファイルの名前ではありません。症例のフォルダー内のパスを指定してください</translation>
    </message>
    <message>
        <source>a material cannot be named %1; take small letters, digits, - and _, at most 40, a letter first</source>
        <translation>材料に %1 という名前は付けられません。小文字、数字、-、_ を 40 字以内で使い、最初は文字にしてください</translation>
    </message>
    <message>
        <source>there are more than %1 materials; leave some out</source>
        <translation>材料が %1 種類を超えています。いくつか除いてください</translation>
    </message>
    <message>
        <source>%1 belongs to new materials; that of %2 is built in</source>
        <translation>%1 は新しい材料だけに付けられます。%2 のものは組み込みです</translation>
    </message>
    <message>
        <source>'role' must be one of %1</source>
        <translation>'role' は %1 のいずれかです</translation>
    </message>
    <message>
        <source>the code %1 is that of %2; give each material its own</source>
        <translation>コード %1 は %2 のものです。材料ごとに別のコードを付けてください</translation>
    </message>
    <message>
        <source>the tooth has more materials than this program can hold beside its own (%1); take materials out of the file of --materials.</source>
        <translation>この歯の材料は、このプログラムの材料と合わせて上限（%1）を超えています。--materials のファイルから材料を減らしてください。</translation>
    </message>
    <message>
        <source>there is no material %1; the materials are %2</source>
        <translation>材料 %1 はありません。使える材料は %2 です</translation>
    </message>
    <message>
        <source>the rotation must be a quaternion of length 1, w first</source>
        <translation>rotation は長さ 1 の四元数（w が先頭）でなければなりません</translation>
    </message>
    <message>
        <source>the position lies more than 1000 mm away; lengths are in mm</source>
        <translation>位置が 1000 mm より遠くにあります。長さの単位は mm です</translation>
    </message>
    <message>
        <source>&apos;material&apos; must be carbide or diamond</source>
        <translation>&apos;material&apos; は carbide か diamond でなければなりません</translation>
    </message>
    <message>
        <source>the surface must lie beside this file or below it, named with &apos;/&apos; and without &apos;..&apos;</source>
        <translation>表面はこのファイルと同じフォルダーかその下に置き、&apos;/&apos; を使い、&apos;..&apos; を使わずに書いてください</translation>
    </message>
    <message>
        <source>%1 must lie beside this file or below it, named with &apos;/&apos; and without &apos;..&apos;</source>
        <translation>%1 はこのファイルと同じフォルダーかその下に置き、&apos;/&apos; を使い、&apos;..&apos; を使わずに書いてください</translation>
    </message>
    <message>
        <source>a built-in tooth brings its own layers</source>
        <translation>内蔵の歯には層が含まれています</translation>
    </message>
    <message>
        <source>&apos;site&apos; must be occlusal, mesial, distal, buccal or lingual</source>
        <translation>&apos;site&apos; は occlusal、mesial、distal、buccal、lingual のいずれかでなければなりません</translation>
    </message>
    <message>
        <source>a front tooth has no occlusal side; choose another site</source>
        <translation>前歯には咬合面がありません。別の部位を選んでください</translation>
    </message>
    <message>
        <source>%1 belongs to a built-in tooth, one by its number</source>
        <translation>%1 が使えるのは、番号で指定した内蔵の歯だけです</translation>
    </message>
    <message>
        <source>there is no bur %1 in the catalogue.</source>
        <translation>バー %1 はカタログにありません。</translation>
    </message>
    <message>
        <source>there is no bur %1 in the catalogue (&apos;tactooth gallery&apos; shows them); a bur of your own is named by its file, .stl or .toml</source>
        <translation>バー %1 はカタログにありません（一覧は &apos;tactooth gallery&apos;）。自分のバーは .stl か .toml のファイル名で指定します</translation>
    </message>
    <message>
        <source>give the ideal shape either by a file, ideal = &quot;FILE.stl&quot;, or by what the bur cuts, below a line [cavity]</source>
        <translation>理想の形は、ファイル（ideal = &quot;FILE.stl&quot;）か、[cavity] の行の下に書くバーの動きの、どちらか一方で指定してください</translation>
    </message>
    <message>
        <source>&apos;floor&apos; must be flat, or surface to follow that of the tooth</source>
        <translation>&apos;floor&apos; は flat か、歯の表面に沿う surface でなければなりません</translation>
    </message>
    <message>
        <source>there are no strokes; give at least one, [[cavity.strokes]]</source>
        <translation>ストロークがありません。[[cavity.strokes]] を少なくとも一つ書いてください</translation>
    </message>
    <message>
        <source>there are too many strokes</source>
        <translation>ストロークが多すぎます</translation>
    </message>
    <message>
        <source>&apos;side&apos; has no direction</source>
        <translation>&apos;side&apos; に向きがありません</translation>
    </message>
    <message>
        <source>&apos;side&apos; must be occlusal, buccal, lingual, mesial, distal, or a direction of three numbers</source>
        <translation>&apos;side&apos; は occlusal、buccal、lingual、mesial、distal のいずれか、または三つの数値による向きでなければなりません</translation>
    </message>
    <message>
        <source>this stroke is longer or farther away than any tooth; places are in mm</source>
        <translation>このストロークは歯の大きさに対して長すぎるか、遠すぎます。位置の単位は mm です</translation>
    </message>
    <message>
        <source>stroke %1 of the cavity goes past the tooth; give places over it, in its frame, mm.</source>
        <translation>窩洞のストローク %1 が歯から外れています。歯の座標系で、歯の上の位置を mm で書いてください。</translation>
    </message>
    <message>
        <source>expected the keys of %1 below a line [%2], but found %3</source>
        <translation>[%2] の行の下に %1 のキーが必要です（実際の値：%3）</translation>
    </message>
    <message>
        <source>&apos;colour&apos; must be three numbers in brackets (red, green, blue), but is %1</source>
        <translation>&apos;colour&apos; は角括弧で囲んだ三つの数値（赤、緑、青）でなければなりません（実際の値：%1）</translation>
    </message>
    <message>
        <source>there is no part %1; the parts are %2</source>
        <translation>%1 という部分はありません。使えるのは %2 です</translation>
    </message>
    <message>
        <source>motor, cutting, water and suction</source>
        <translation>motor、cutting、water、suction</translation>
    </message>
    <message>
        <source>file, speed_rpm and gain_db</source>
        <translation>file、speed_rpm、gain_db</translation>
    </message>
    <message>
        <source>&apos;cutting&apos; needs a material: write [cutting.enamel]</source>
        <translation>&apos;cutting&apos; には材料が必要です。[cutting.enamel] のように書いてください</translation>
    </message>
    <message>
        <source>%1 must be a table with the keys %2</source>
        <translation>%1 は %2 のキーを持つテーブルでなければなりません</translation>
    </message>
    <message>
        <source>%1 has no recording; add file = &quot;NAME.wav&quot;</source>
        <translation>%1 に録音がありません。file = &quot;NAME.wav&quot; を加えてください</translation>
    </message>
    <message>
        <source>%1 needs the speed of the bur when it was recorded, whose pitch it follows; add speed_rpm = 400000 or what it was</source>
        <translation>%1 には録音したときのバーの回転数が必要です（音の高さがこれに従います）。speed_rpm = 400000 のように加えてください</translation>
    </message>
    <message>
        <source>&apos;file&apos; must be a name in quotes</source>
        <translation>&apos;file&apos; は引用符で囲んだ名前でなければなりません</translation>
    </message>
    <message>
        <source>%1 is a link that leads out of the folder of this file; put a copy there instead.</source>
        <translation>%1 はこのファイルのフォルダーの外を指すリンクです。代わりに複製を置いてください。</translation>
    </message>
    <message>
        <source>%1: the recording has %2 samples a second, but 4000 to 192000 are needed; save it at 48000.</source>
        <translation>%1：録音のサンプリング周波数が %2 Hz です。4000～192000 Hz が必要です。48000 Hz で保存してください。</translation>
    </message>
    <message>
        <source>%1: the recording lasts %2 s, but a loop needs 0.05 to 30 s; cut out a steady piece.</source>
        <translation>%1：録音の長さが %2 秒です。ループには 0.05～30 秒が必要です。音の安定した部分を切り出してください。</translation>
    </message>
    <message>
        <source>%1: sample %2 is not a finite number; save the recording again.</source>
        <translation>%1：%2 番目のサンプルが有限の数値ではありません。録音を保存し直してください。</translation>
    </message>
    <message>
        <source>%1: the recording is silent or far too loud to be one; record it again.</source>
        <translation>%1：録音が無音か、録音とは思えないほど大きな音です。録音し直してください。</translation>
    </message>
    <message>
        <source>%1: this is neither WAV, FLAC nor Ogg; save the recording as one of these.</source>
        <translation>%1：WAV、FLAC、Ogg のいずれでもありません。録音をいずれかの形式で保存してください。</translation>
    </message>
    <message>
        <source>%1: the recording has %2 channels, but 1 to 8 are expected; save it with one.</source>
        <translation>%1：録音のチャンネル数が %2 です。1～8 でなければなりません。モノラルで保存してください。</translation>
    </message>
    <message>
        <source>%1: the recording lasts longer than the 30 s of a loop; cut out a steady piece.</source>
        <translation>%1：録音がループの上限の 30 秒を超えています。音の安定した部分を切り出してください。</translation>
    </message>
    <message>
        <source>%1: the file is shorter than it says; it was cut off, so copy or record it again.</source>
        <translation>%1：ファイルが本来より短く、途中で切れています。コピーし直すか、録音し直してください。</translation>
    </message>
    <message>
        <source>%1: the file breaks off or is damaged (%2); copy or record it again.</source>
        <translation>%1：ファイルが途中で切れているか、壊れています（%2）。コピーし直すか、録音し直してください。</translation>
    </message>
    <message>
        <source>%1: this is not a recording that can be read (%2); save it as WAV, FLAC or Ogg.</source>
        <translation>%1：読み込める録音ではありません（%2）。WAV、FLAC、Ogg のいずれかで保存してください。</translation>
    </message>
    <message>
        <source>%1 takes %2, pen:NAME, inverse3:ID or gamepad:NAME for one of several, or replay:FILE.csv, not &apos;%3&apos;; &apos;tactooth devices&apos; shows what is there.</source>
        <translation>%1 に &apos;%3&apos; は指定できません。%2 のいずれか、複数あるときは pen:NAME、inverse3:ID、gamepad:NAME、または replay:FILE.csv を指定してください。&apos;tactooth devices&apos; で接続中の装置が分かります。</translation>
    </message>
    <message>
        <source>the pedal &apos;%1&apos; is none: it is axis:N or button:N of a joystick (N from 0 to 31), with :NAME of the joystick behind it if there are several.</source>
        <translation>&apos;%1&apos; はペダルではありません。ジョイスティックの axis:N か button:N（N は 0～31）で書き、複数あるときは後ろに :NAME を付けてください。</translation>
    </message>
    <message>
        <source>There is no gamepad%1: plug one in or switch it on, and see that you may read /dev/input.</source>
        <translation>ゲームパッド%1が見つかりません。接続するか電源を入れ、/dev/input を読む権限を確かめてください。</translation>
    </message>
    <message>
        <source> named &apos;%1&apos;</source>
        <translation>「%1」</translation>
    </message>
    <message>
        <source>Joysticks cannot be read (%1).</source>
        <translation>ジョイスティックを読めません（%1）。</translation>
    </message>
    <message>
        <source>A gamepad steers already; there is one for each program.</source>
        <translation>ゲームパッドはすでに使われています。使えるのは一つのプログラムにつき1台です。</translation>
    </message>
    <message>
        <source>A SpaceMouse steers already; there is one for each program.</source>
        <translation>SpaceMouseはすでに使われています。使えるのは一つのプログラムにつき1台です。</translation>
    </message>
    <message>
        <source>The SpaceMouse&apos;s driver does not run: install spacenavd, start it (sudo systemctl start spacenavd) and plug the SpaceMouse in.</source>
        <translation>SpaceMouseのドライバーが動いていません。spacenavdをインストールして起動し（sudo systemctl start spacenavd）、SpaceMouseを接続してください。</translation>
    </message>
    <message>
        <source>OpenHaptics, %1: %2</source>
        <translation>OpenHaptics、%1：%2</translation>
    </message>
    <message>
        <source>the default device</source>
        <translation>標準の装置</translation>
    </message>
    <message>
        <source>the device &apos;%1&apos;</source>
        <translation>装置「%1」</translation>
    </message>
    <message>
        <source>OpenHaptics knows no device for %1: look its name up in the vendor&apos;s setup program.</source>
        <translation>OpenHapticsに%1が登録されていません。メーカーの設定プログラムで名前を確かめてください。</translation>
    </message>
    <message>
        <source>OpenHaptics knows no device for %1: choose one that is set up (%2), or set it up in the vendor&apos;s setup program.</source>
        <translation>OpenHapticsに%1が登録されていません。登録済みの装置（%2）から選ぶか、メーカーの設定プログラムで登録してください。</translation>
    </message>
    <message>
        <source>OpenHaptics: four devices are in use already; close one of them.</source>
        <translation>OpenHaptics：すでに4台の装置が使用中です。1台を閉じてください。</translation>
    </message>
    <message>
        <source>%1 cannot be loaded (%2): install the device&apos;s driver and OpenHaptics, or set TACTOOTH_LIBHD to the library.</source>
        <translation>%1 を読み込めません（%2）。装置のドライバーとOpenHapticsをインストールするか、TACTOOTH_LIBHD にライブラリの場所を設定してください。</translation>
    </message>
    <message>
        <source>%1 has no function %2: it is another version; install OpenHaptics 3.4 or newer.</source>
        <translation>%1 に関数 %2 がありません。バージョンが違います。OpenHaptics 3.4 以降をインストールしてください。</translation>
    </message>
    <message>
        <source>The Haply Inverse Service does not answer at %1: install and start it, or set TACTOOTH_HAPLY to where it listens.</source>
        <translation>Haply Inverse Serviceが %1 で応答しません。インストールして起動するか、TACTOOTH_HAPLY に待ち受け先を設定してください。</translation>
    </message>
    <message>
        <source>What answers at %1 is not the Haply Inverse Service: end that program, or set TACTOOTH_HAPLY to where the service listens.</source>
        <translation>%1 で応答しているのはHaply Inverse Serviceではありません。そのプログラムを終了するか、TACTOOTH_HAPLY に待ち受け先を設定してください。</translation>
    </message>
    <message>
        <source>The Haply Inverse Service finds no Inverse3: check its cable and power supply.</source>
        <translation>Haply Inverse ServiceがInverse3を見つけられません。ケーブルと電源を確かめてください。</translation>
    </message>
    <message>
        <source>The Haply Inverse Service knows no Inverse3 &apos;%1&apos;: it finds %2.</source>
        <translation>Haply Inverse Serviceに Inverse3 &apos;%1&apos; がありません。見つかったのは %2 です。</translation>
    </message>
    <message>
        <source>The motors are warm: rest the pen for a minute; until then the force is weaker.</source>
        <translation>モーターが熱くなっています。ペンを1分ほど休ませてください。それまで力は弱くなります。</translation>
    </message>
    <message>
        <source>The driver has cut a force that was too strong; press more gently.</source>
        <translation>強すぎる力をドライバーが制限しました。もっと軽く押してください。</translation>
    </message>
    <message>
        <source>The driver has cut a force that rose too fast; move the pen more slowly into the tooth.</source>
        <translation>急すぎる力をドライバーが制限しました。ペンをもっとゆっくり歯に近づけてください。</translation>
    </message>
    <message>
        <source>The pen was moved faster than its driver allows; the force comes back by itself.</source>
        <translation>ドライバーが許すより速くペンが動かされました。力は自動的に戻ります。</translation>
    </message>
    <message>
        <source>The driver reports a force error: switch the device off and on again.</source>
        <translation>ドライバーが力のエラーを報告しています。装置の電源を入れ直してください。</translation>
    </message>
    <message>
        <source>The device reports a fault: check its power supply and cable, then switch it off and on again.</source>
        <translation>装置が故障を報告しています。電源とケーブルを確かめ、電源を入れ直してください。</translation>
    </message>
    <message>
        <source>The device is in use: close the other program that holds it.</source>
        <translation>装置は使用中です。装置を使っている他のプログラムを閉じてください。</translation>
    </message>
    <message>
        <source>The device does not answer: check its cable and power supply; it is tried again every second.</source>
        <translation>装置が応答しません。ケーブルと電源を確かめてください。1秒ごとに再試行します。</translation>
    </message>
    <message>
        <source>The device is not set up: run the vendor&apos;s setup program and pair it.</source>
        <translation>装置が設定されていません。メーカーの設定プログラムでペアリングしてください。</translation>
    </message>
    <message>
        <source>The driver&apos;s timer does not run: start the vendor&apos;s service, or restart the computer.</source>
        <translation>ドライバーのタイマーが動いていません。メーカーのサービスを起動するか、コンピューターを再起動してください。</translation>
    </message>
    <message>
        <source>The driver takes no more work: close other programs that use the device.</source>
        <translation>ドライバーがこれ以上受け付けません。装置を使う他のプログラムを閉じてください。</translation>
    </message>
    <message>
        <source>The vendor&apos;s library finds no licence: install OpenHaptics with its licence.</source>
        <translation>メーカーのライブラリにライセンスが見つかりません。OpenHapticsをライセンスとともにインストールしてください。</translation>
    </message>
    <message>
        <source>The device&apos;s driver reports an error: switch the device off and on again and restart Tactooth.</source>
        <translation>装置のドライバーがエラーを報告しています。装置の電源を入れ直し、Tactoothを再起動してください。</translation>
    </message>
    <message>
        <source>Put the pen into its inkwell for a moment, so that the device learns where it is.</source>
        <translation>装置が位置を覚えるように、ペンを少しの間インクウェルに差し込んでください。</translation>
    </message>
    <message>
        <source>The device has stopped answering: check its cable and power supply; the session goes on when it is back.</source>
        <translation>装置の応答が止まりました。ケーブルと電源を確かめてください。戻ればそのまま続けられます。</translation>
    </message>
    <message>
        <source>The gamepad has been unplugged: plug it in again, and the session goes on.</source>
        <translation>ゲームパッドが外れました。もう一度接続すれば、そのまま続けられます。</translation>
    </message>
    <message>
        <source>The SpaceMouse&apos;s driver has stopped: start it again (sudo systemctl start spacenavd), and the session goes on.</source>
        <translation>SpaceMouseのドライバーが止まりました。もう一度起動すれば（sudo systemctl start spacenavd）、そのまま続けられます。</translation>
    </message>
    <message>
        <source>The Haply Inverse Service answers too slowly: close other programs that keep this machine busy.</source>
        <translation>Haply Inverse Serviceの応答が遅すぎます。コンピューターに負荷をかけている他のプログラムを閉じてください。</translation>
    </message>
    <message>
        <source>The Haply Inverse Service has closed the connection: start it again; it is tried again every second.</source>
        <translation>Haply Inverse Serviceが接続を閉じました。もう一度起動してください。1秒ごとに再試行します。</translation>
    </message>
    <message>
        <source>The Haply Inverse Service has stopped answering: restart it; it is tried again every second.</source>
        <translation>Haply Inverse Serviceの応答が止まりました。再起動してください。1秒ごとに再試行します。</translation>
    </message>
    <message>
        <source>The Haply Inverse Service sends what is no message: restart it; if that does not help, install it anew.</source>
        <translation>Haply Inverse Serviceから正しくない通信が届きました。再起動し、それでも直らなければ再インストールしてください。</translation>
    </message>
    <message>
        <source>The Haply Inverse Service speaks another version of its language: install version 3.</source>
        <translation>Haply Inverse Serviceの通信のバージョンが違います。バージョン3をインストールしてください。</translation>
    </message>
    <message>
        <source>The Haply Inverse Service tells places that are not in metres: install version 3 of it.</source>
        <translation>Haply Inverse Serviceの位置の単位がメートルではありません。バージョン3をインストールしてください。</translation>
    </message>
    <message>
        <source>The Inverse3 does not know where it is: put its arms into their rest position and switch it off and on again.</source>
        <translation>Inverse3の位置が分かりません。アームを休止位置に置き、電源を入れ直してください。</translation>
    </message>
    <message>
        <source>The Inverse3 is gone: check its cable and power supply; the session goes on when it is back.</source>
        <translation>Inverse3が見つからなくなりました。ケーブルと電源を確かめてください。戻ればそのまま続けられます。</translation>
    </message>
    <message>
        <source>The Inverse3 has no power: plug in its power supply.</source>
        <translation>Inverse3に電源が来ていません。電源をつないでください。</translation>
    </message>
    <message>
        <source>The Inverse3 is not calibrated: hold its arms in their rest position until its light stays on.</source>
        <translation>Inverse3が校正されていません。ランプが点灯したままになるまでアームを休止位置に保ってください。</translation>
    </message>
    <message>
        <source>The Inverse3 is not ready: wait for its light, or switch it off and on again.</source>
        <translation>Inverse3の準備ができていません。ランプを待つか、電源を入れ直してください。</translation>
    </message>
    <message>
        <source>The VerseGrip is asleep: press one of its buttons.</source>
        <translation>VerseGripがスリープしています。ボタンを一つ押してください。</translation>
    </message>
    <message>
        <source>The device tells a place that is no number: switch it off and on again if this comes again.</source>
        <translation>装置の位置が数値になっていません。繰り返すときは電源を入れ直してください。</translation>
    </message>
    <message>
        <source>The device&apos;s place has jumped: check its cable, and let it calibrate if this comes again.</source>
        <translation>装置の位置が飛びました。ケーブルを確かめ、繰り返すときは校正してください。</translation>
    </message>
    <message>
        <source>The device&apos;s driver calls far too often, so the force is off: restart the vendor&apos;s service, or the computer.</source>
        <translation>装置のドライバーの呼び出しが多すぎるため、力を切りました。メーカーのサービスかコンピューターを再起動してください。</translation>
    </message>
    <message>
        <source>The device tells a direction that is none: switch it off and on again if this comes again.</source>
        <translation>装置の向きが正しい値になっていません。繰り返すときは電源を入れ直してください。</translation>
    </message>
    <message>
        <source>The device moved faster than 1.5 m/s at the tooth, so its force is off: lift the bur, and check the cable if the hand was slow.</source>
        <translation>歯に触れている間に装置が毎秒1.5 mより速く動いたため、力を切りました。バーを歯から離してください。手がゆっくりだったときは、ケーブルを確かめてください。</translation>
    </message>
    <message>
        <source>The device&apos;s direction has jumped: switch it off and on again if this comes again.</source>
        <translation>装置の向きが飛びました。繰り返すときは電源を入れ直してください。</translation>
    </message>
    <message>
        <source>The device&apos;s places come too late: close other programs that keep this machine busy.</source>
        <translation>装置の位置が遅れて届いています。コンピューターに負荷をかけている他のプログラムを閉じてください。</translation>
    </message>
    <message>
        <source>The force came out as no number and was switched off: lift the bur, and report it to the authors if this comes again.</source>
        <translation>力が数値にならなかったため、力を切りました。バーを歯から離してください。繰り返すときは作者に知らせてください。</translation>
    </message>
    <message>
        <source>The VerseGrip tells a direction that is none: switch it off and on again if this comes again.</source>
        <translation>VerseGripの向きが正しい値になっていません。繰り返すときは電源を入れ直してください。</translation>
    </message>
    <message>
        <source>The Haply Inverse Service sends more answers than it is asked for, so the force is off: restart the service.</source>
        <translation>Haply Inverse Serviceが問い合わせより多くの応答を送ってくるため、力を切りました。サービスを再起動してください。</translation>
    </message>
    <message>
        <source>it closes what it has not opened</source>
        <translation>自分で開いていないものを閉じます</translation>
    </message>
    <message>
        <source>.</source>
        <translation>。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
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
        <source>Touch (T): the bur stands still and feels the tooth</source>
        <translation>触診（T）：バーは止まったまま歯に触れます</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切削</translation>
    </message>
    <message>
        <source>Cut (C): with the pedal down the bur turns and cuts</source>
        <translation>切削（C）：ペダルを踏むとバーが回り、歯を削ります</translation>
    </message>
    <message>
        <source>Undo cut</source>
        <translation>切削を戻す</translation>
    </message>
    <message>
        <source>Takes back the last cut (Ctrl+Z)</source>
        <translation>最後の切削を取り消します（Ctrl+Z）</translation>
    </message>
    <message>
        <source>Reset tooth</source>
        <translation>歯を元に戻す</translation>
    </message>
    <message>
        <source>Puts back all that was cut (Ctrl+R)</source>
        <translation>削ったところをすべて元に戻します（Ctrl+R）</translation>
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
        <source>How deep the mouse hand presses beyond the surface.
The mouse wheel in the picture changes it too.</source>
        <translation>マウスの手が表面よりどれだけ深く押すか。
画面上のマウスホイールでも変えられます。</translation>
    </message>
    <message>
        <source>Defaults</source>
        <translation>初期値</translation>
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
        <source>Cut (C) and the pedal (space): the bur turns and removes what it presses on</source>
        <translation>切削（C）とペダル（スペース）：バーが回り、押したところを削ります</translation>
    </message>
    <message>
        <source>Button up, pedal up</source>
        <translation>ボタンとペダルを放します</translation>
    </message>
    <message>
        <source>Ctrl+Z takes the cut back. Now it is your turn</source>
        <translation>Ctrl+Z で切削を取り消します。次はあなたの番です</translation>
    </message>
</context>
<context>
    <name>tactooth::InspectionPanel</name>
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
        <source>%1 — Tactooth</source>
        <translation>%1 — Tactooth</translation>
    </message>
    <message>
        <source>This case brings its own materials: it may feel harder, softer or rougher than others</source>
        <translation>この症例には独自の材料が含まれています。ほかの症例より硬く、柔らかく、またはざらついて感じられることがあります</translation>
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
</context>
<context>
    <name>tactooth::ExerciseController</name>
    <message>
        <source>Preparing the exercise: %1…</source>
        <translation>課題を準備中：%1…</translation>
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
</context>
<context>
    <name>tactooth::FileMenu</name>
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
        <source>&amp;Whole mouth</source>
        <translation>口全体(&amp;W)</translation>
    </message>
    <message>
        <source>Upper right</source>
        <translation>右上</translation>
    </message>
    <message>
        <source>Upper left</source>
        <translation>左上</translation>
    </message>
    <message>
        <source>Lower left</source>
        <translation>左下</translation>
    </message>
    <message>
        <source>Lower right</source>
        <translation>右下</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>まだありません</translation>
    </message>
</context>
<context>
    <name>tactooth::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Welcome</source>
        <translation>ようこそ(&amp;W)</translation>
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
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>the bur hovers over the point under the mouse</source>
        <translation>マウスの下の点の上にバーが浮きます</translation>
    </message>
    <message>
        <source>Left button</source>
        <translation>左ボタン</translation>
    </message>
    <message>
        <source>the bur goes down and presses; drag to stroke or cut</source>
        <translation>バーが下りて押します。ドラッグでなでる・削る</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>press harder or softer</source>
        <translation>強く／弱く押す</translation>
    </message>
    <message>
        <source>Shift + move</source>
        <translation>Shift + 移動</translation>
    </message>
    <message>
        <source>lean the bur</source>
        <translation>バーを傾ける</translation>
    </message>
    <message>
        <source>Right button</source>
        <translation>右ボタン</translation>
    </message>
    <message>
        <source>turn the tooth</source>
        <translation>歯を回す</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>中ボタン</translation>
    </message>
    <message>
        <source>shift the picture</source>
        <translation>画面をずらす</translation>
    </message>
    <message>
        <source>Ctrl + wheel</source>
        <translation>Ctrl + ホイール</translation>
    </message>
    <message>
        <source>nearer or farther</source>
        <translation>近づく／離れる</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>矢印キー</translation>
    </message>
    <message>
        <source>move the bur; with Shift lean it, with Ctrl turn the tooth</source>
        <translation>バーを動かす。Shift で傾け、Ctrl で歯を回す</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>the bur presses, as long as you hold it</source>
        <translation>押している間、バーが押し付けられる</translation>
    </message>
    <message>
        <source>+, -</source>
        <translation>+、-</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>スペース</translation>
    </message>
    <message>
        <source>the pedal, as long as you hold it</source>
        <translation>押している間ペダルを踏む</translation>
    </message>
    <message>
        <source>T, C</source>
        <translation>T、C</translation>
    </message>
    <message>
        <source>touch, cut</source>
        <translation>触診、切削</translation>
    </message>
    <message>
        <source>0 to 5, F</source>
        <translation>0～5、F</translation>
    </message>
    <message>
        <source>views; show the whole crown</source>
        <translation>視点；歯冠全体を表示</translation>
    </message>
    <message>
        <source>Ctrl + 0 to 5</source>
        <translation>Ctrl + 0～5</translation>
    </message>
    <message>
        <source>a small picture from that side beside the large one; none</source>
        <translation>その向きの小さな画面を添える；なし</translation>
    </message>
    <message>
        <source>Q, E, U</source>
        <translation>Q、E、U</translation>
    </message>
    <message>
        <source>turn the handle; stand the bur upright</source>
        <translation>柄を回す；バーを垂直に</translation>
    </message>
    <message>
        <source>M, H</source>
        <translation>M、H</translation>
    </message>
    <message>
        <source>mirror, turbine on and off</source>
        <translation>ミラー、タービンの表示切替</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>the cavity that the target wants cut, on and off</source>
        <translation>目標が求める窩洞の表示のオン・オフ</translation>
    </message>
    <message>
        <source>B, D</source>
        <translation>B、D</translation>
    </message>
    <message>
        <source>breath and drops on the mirror</source>
        <translation>ミラーの曇りと水滴</translation>
    </message>
    <message>
        <source>W, S</source>
        <translation>W、S</translation>
    </message>
    <message>
        <source>water spray, suction on and off</source>
        <translation>注水と吸引のオン・オフ</translation>
    </message>
    <message>
        <source>Ctrl + Z</source>
        <translation>Ctrl + Z</translation>
    </message>
    <message>
        <source>take back the last cut</source>
        <translation>最後の切削を取り消す</translation>
    </message>
    <message>
        <source>Ctrl + R</source>
        <translation>Ctrl + R</translation>
    </message>
    <message>
        <source>put back all that was cut</source>
        <translation>削ったところをすべて戻す</translation>
    </message>
    <message>
        <source>Ctrl + O, S, Shift + S</source>
        <translation>Ctrl + O、S、Shift + S</translation>
    </message>
    <message>
        <source>open a tooth, save it, export its surface</source>
        <translation>歯を開く、保存、表面を書き出す</translation>
    </message>
    <message>
        <source>Ctrl + I</source>
        <translation>Ctrl + I</translation>
    </message>
    <message>
        <source>import a scan</source>
        <translation>スキャンを取り込む</translation>
    </message>
    <message>
        <source>Ctrl + D</source>
        <translation>Ctrl + D</translation>
    </message>
    <message>
        <source>dark colours</source>
        <translation>暗い配色</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>hold the bur while the hand of a device moves on</source>
        <translation>装置の手が動く間、バーをその場に保つ</translation>
    </message>
    <message>
        <source>Gamepad: sticks</source>
        <translation>ゲームパッド：スティック</translation>
    </message>
    <message>
        <source>left: move; right: lean the bur</source>
        <translation>左：移動、右：バーを傾ける</translation>
    </message>
    <message>
        <source>Gamepad: left trigger, shoulder</source>
        <translation>ゲームパッド：左トリガー、ショルダー</translation>
    </message>
    <message>
        <source>press, lift</source>
        <translation>押す、持ち上げる</translation>
    </message>
    <message>
        <source>Gamepad: right trigger, shoulder</source>
        <translation>ゲームパッド：右トリガー、ショルダー</translation>
    </message>
    <message>
        <source>pedal, hold</source>
        <translation>ペダル、保持</translation>
    </message>
    <message>
        <source>Gamepad: A, B</source>
        <translation>ゲームパッド：A、B</translation>
    </message>
    <message>
        <source>touch or cut, turbine or mirror</source>
        <translation>触る／削る、タービン／ミラー</translation>
    </message>
    <message>
        <source>Gamepad: d-pad</source>
        <translation>ゲームパッド：十字キー</translation>
    </message>
    <message>
        <source>turn the tooth; with the right shoulder shift the picture</source>
        <translation>歯を回す。右ショルダーと一緒なら画像をずらす</translation>
    </message>
    <message>
        <source>Gamepad: sticks, pressed in</source>
        <translation>ゲームパッド：スティックの押し込み</translation>
    </message>
    <message>
        <source>left: farther; right: nearer</source>
        <translation>左：遠ざかる、右：近づく</translation>
    </message>
    <message>
        <source>Gamepad: Start, Back</source>
        <translation>ゲームパッド：Start、Back</translation>
    </message>
    <message>
        <source>open the menus; go into the panels, shoulders: the next one</source>
        <translation>メニューを開く、パネルに入る（ショルダーで次のパネル）</translation>
    </message>
    <message>
        <source>Gamepad: d-pad, A, B</source>
        <translation>ゲームパッド：十字キー、A、B</translation>
    </message>
    <message>
        <source>in menus, dialogs and panels: go on, choose, leave</source>
        <translation>メニュー、ダイアログ、パネルで：進む、選ぶ、戻る</translation>
    </message>
    <message>
        <source>Ctrl + M</source>
        <translation>Ctrl + M</translation>
    </message>
    <message>
        <source>mute</source>
        <translation>消音</translation>
    </message>
    <message>
        <source>Tab, Alt + letter</source>
        <translation>Tab、Alt + 文字</translation>
    </message>
    <message>
        <source>go on to the next control; open a menu</source>
        <translation>次の項目へ移る。メニューを開く</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>leave a dialog</source>
        <translation>ダイアログを閉じる</translation>
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
    <name>tactooth::ToothController</name>
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
</context>
<context>
    <name>tactooth::ViewMenu</name>
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
</context>
<context>
    <name>tactooth::WindowHints</name>
    <message>
        <source>Left button: press the bur on the tooth · wheel: harder, softer · right: turn · space: pedal</source>
        <translation>左ボタン：バーを歯に押す・ホイール：強く／弱く・右：回す・スペース：ペダル</translation>
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
        <source>Move the device: the bur follows it · space: pedal · C: cut, T: touch</source>
        <translation>装置を動かすとバーが従います · スペース：ペダル · C：削る、T：触る</translation>
    </message>
    <message>
        <source>The scene is heavy for this machine: one tick in a hundred takes %1 of the %2 µs that there are; take a tooth of fewer triangles (&apos;tactooth simplify&apos;) or a bur of fewer triangles, and close other programs.</source>
        <translation>このコンピューターには負荷が大きすぎます：100 回に 1 回の計算が、使える %2 µs のうち %1 µs を要しています。三角形の少ない歯（&apos;tactooth simplify&apos;）または三角形の少ないバーを使い、他のプログラムを終了してください。</translation>
    </message>
    <message>
        <source>In Touch the bur stands still: choose Cut (C), and the pedal turns it</source>
        <translation>触診ではバーは回りません：切削（C）を選ぶとペダルで回ります</translation>
    </message>
    <message>
        <source>Blue glass: still to cut, darker where deeper. Dark line: the outline.</source>
        <translation>青いガラス：削り残し（深いほど濃い）。濃い線：外形。</translation>
    </message>
    <message>
        <source>The hand is at the end of the device&apos;s room: hold the bur (X), bring the hand back and let go</source>
        <translation>手が装置の可動域の端にあります。バーを保持して（X）手を戻し、離してください</translation>
    </message>
    <message>
        <source>The bur stands still: hold the pedal (%1), or tick Keep down</source>
        <translation>バーは止まっています。ペダル（%1）を踏み続けるか、「踏んだまま」を選んでください</translation>
    </message>
    <message>
        <source>The bur only touches: choose Cut (C) to remove something</source>
        <translation>バーは触れているだけです。削るには「切削」（C）を選んでください</translation>
    </message>
</context>
<context>
    <name>tactooth::WindowMenus</name>
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
</context>
<context>
    <name>tactooth::WindowMessages</name>
    <message>
        <source>Tactooth</source>
        <translation>Tactooth</translation>
    </message>
</context>
<context>
    <name>tactooth::OpenToothDialog</name>
    <message>
        <source>Open tooth</source>
        <translation>歯を開く</translation>
    </message>
    <message>
        <source>The tooth&apos;s outer surface is felt and seen. Closed surfaces inside it say where each tissue is; without them the whole tooth is enamel. STL files in millimetres, or a case or a saved tooth, which have all of these.</source>
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
        <source>Depth, mm</source>
        <translation>深さ mm</translation>
    </message>
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
        <source>The force is computed by a thread of its own, 1000 times a second.
p99: 99 % of the ticks take less. Missed: ticks that the system gave no time for.</source>
        <translation>力は専用スレッドが毎秒1000回計算します。
p99：99 % の周期はこれより短い。欠落：システムが時間を与えなかった周期。</translation>
    </message>
    <message>
        <source>Servo %1 Hz, p99 %2 µs, missed %3, %4  |  surface %5/s</source>
        <translation>サーボ %1 Hz、p99 %2 µs、欠落 %3、%4  |  表面 %5/秒</translation>
    </message>
    <message>
        <source>Servo %1 Hz</source>
        <translation>サーボ %1 Hz</translation>
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
        <source>The share of ticks in the last second that came too late for the force.
More than 1 % is felt: close other programs, or take a tooth with fewer triangles.</source>
        <translation>直前の1秒間で力の計算に間に合わなかった割合。
1 %を超えると手に感じられます。他のプログラムを閉じるか、三角形の少ない歯を使ってください。</translation>
    </message>
    <message>
        <source>late %1 %</source>
        <translation>遅れ %1 %</translation>
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
        <source>A scan of your own, in whatever unit and position: you see first what it is taken for.</source>
        <translation>自分のスキャン。単位や向きは問いません。どう解釈されたかを先に確かめられます。</translation>
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
        <source>All of this is in the menus, too; F1 shows mouse and keys.</source>
        <translation>これらはメニューにもあります。F1 でマウスとキーを表示します。</translation>
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
        <source>How often the force is made anew: 500 Hz for a slow machine, where walls are felt half as stiff; more than 1000 Hz for a smoother force, if the device&apos;s driver bears it</source>
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
        <source>Haptic pen %1</source>
        <translation>力覚ペン %1</translation>
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
        <source>Fineness</source>
        <translation>細かさ</translation>
    </message>
    <message>
        <source> : 1</source>
        <translation> : 1</translation>
    </message>
    <message>
        <source>How far a device&apos;s hand moves for each millimetre of the bur: 3 : 1 for fine work</source>
        <translation>バーが1 mm動くごとに装置の手が動く距離。細かい作業には3 : 1</translation>
    </message>
    <message>
        <source>Fit to the tooth</source>
        <translation>歯に合わせる</translation>
    </message>
    <message>
        <source>As fine as it can be while the device&apos;s room still reaches all of the tooth</source>
        <translation>装置の可動域で歯全体に届く範囲で、できるだけ細かくします</translation>
    </message>
    <message>
        <source>The tooth is larger than the device&apos;s room: hold the bur (X) to reach all of it.</source>
        <translation>歯が装置の可動域より大きいので、全体に届かせるにはバーを保持してください（X）。</translation>
    </message>
    <message>
        <source>Nothing here has a room that could be fitted: 1 : 1.</source>
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
        <source>The bur stays while the hand goes back to a comfortable place (X, or a button of the device)</source>
        <translation>手を楽な位置に戻す間、バーをその場に保ちます（X、または装置のボタン）</translation>
    </message>
    <message>
        <source>Handles leave to the other side, and a gamepad&apos;s halves change places</source>
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
</context>
<context>
    <name>Remarks</name>
    <message>
        <source>Units taken as %1, because the longest side would be %2 mm, as that of a whole tooth.</source>
        <translation>単位は %1 とみなしました。最も長い辺が %2 mm となり、歯全体の大きさに合うためです。</translation>
    </message>
    <message>
        <source>Units taken as %1, because the longest side would be %2 mm, as that of a crown.</source>
        <translation>単位は %1 とみなしました。最も長い辺が %2 mm となり、歯冠の大きさに合うためです。</translation>
    </message>
    <message>
        <source>No unit of length makes this a tooth (longest side %1): scaled by %2 to the %3 mm of an average tooth.</source>
        <translation>どの長さの単位でも歯の大きさになりません（最も長い辺 %1）。%2 倍して平均的な歯の長さ %3 mm にしました。</translation>
    </message>
    <message>
        <source>There is one layer: its surface is the tooth&apos;s.</source>
        <translation>層は一つだけです。その表面を歯の表面とします。</translation>
    </message>
    <message>
        <source>The outer surface was welded from the layers: vertices within %1 mm became one, and faces in common fell away.</source>
        <translation>外表面は層をつなぎ合わせて作りました。%1 mm 以内の頂点は一つにし、共有する面は取り除きました。</translation>
    </message>
    <message>
        <source>The layers do not fit within %1 mm: the outer surface was made anew around all of them, with triangles of %2 mm.</source>
        <translation>層は %1 mm 以内では合いません。全体を囲む外表面を %2 mm の三角形で作り直しました。</translation>
    </message>
    <message>
        <source>The surface is about as long as wide: +z of the file is taken as the crown&apos;s side.</source>
        <translation>長さと幅がほぼ同じです。ファイルの +z を歯冠の側とみなしました。</translation>
    </message>
    <message>
        <source>The crown is where the enamel is.</source>
        <translation>エナメル質のある側を歯冠としました。</translation>
    </message>
    <message>
        <source>The thicker end of the long axis is taken as the crown.</source>
        <translation>長軸の太い側を歯冠とみなしました。</translation>
    </message>
    <message>
        <source>The cheek&apos;s side is the one that looks away from the middle of the arch.</source>
        <translation>歯列弓の中央から外を向く側を頬側としました。</translation>
    </message>
    <message>
        <source>It stands crown up as it came (%1 degrees from +z): its axes are kept, with the cheek at +y.</source>
        <translation>もとのまま歯冠が上を向いています（+z から %1 度）。軸はそのままとし、+y を頬側とします。</translation>
    </message>
    <message>
        <source>Turned by %1 degrees to stand crown up; the cheek&apos;s side cannot be seen from one surface and is taken to be +y of the file.</source>
        <translation>歯冠が上を向くように %1 度回しました。頬側は一つの表面からは分からないため、ファイルの +y とみなしました。</translation>
    </message>
    <message>
        <source>Turned upside down, as chosen.</source>
        <translation>指定により上下を逆にしました。</translation>
    </message>
    <message>
        <source>Turned by %1 degrees about the long axis, as chosen.</source>
        <translation>指定により長軸のまわりに %1 度回しました。</translation>
    </message>
    <message>
        <source>Scaled by %1, as chosen: the longest side is %2 mm.</source>
        <translation>指定により %1 倍しました。最も長い辺は %2 mm です。</translation>
    </message>
    <message>
        <source>%1: %2 empty or doubled triangles were dropped.</source>
        <translation>%1：面積のない、または重複した三角形 %2 個を取り除きました。</translation>
    </message>
    <message>
        <source>%1: %2 crumbs beside the surface were dropped.</source>
        <translation>%1：表面から離れた小片 %2 個を取り除きました。</translation>
    </message>
    <message>
        <source>%1: %2 triangles were turned to look outward.</source>
        <translation>%1：三角形 %2 個を外向きに直しました。</translation>
    </message>
    <message>
        <source>%1: %2 holes were filled, the largest with a rim of %3 mm.</source>
        <translation>%1：穴 %2 個をふさぎました。最大の穴の縁は %3 mm です。</translation>
    </message>
    <message>
        <source>%1: closed and sound as it came, %2 triangles.</source>
        <translation>%1：もとから閉じていて問題ありません（三角形 %2 個）。</translation>
    </message>
    <message>
        <source>%1: consists of %2 separate shells.</source>
        <translation>%1：%2 個の独立した殻からなります。</translation>
    </message>
    <message>
        <source>%1: %2 corners that differ in their last digits were welded, within %3 mm.</source>
        <translation>%1：末尾の桁だけが異なる頂点 %2 個をつなぎました（%3 mm 以内）。</translation>
    </message>
    <message>
        <source>%1: %2 triangles that are stored twice, or lie back to back, were dropped.</source>
        <translation>%1：重複した、または背中合わせの三角形 %2 個を取り除きました。</translation>
    </message>
    <message>
        <source>%1: %2 specks beside the surface were dropped.</source>
        <translation>%1：表面から離れた微小な断片 %2 個を取り除きました。</translation>
    </message>
    <message>
        <source>%1: %2 triangles were turned, so that all look at the outside.</source>
        <translation>%1：すべてが外側を向くように三角形 %2 個の向きを直しました。</translation>
    </message>
    <message>
        <source>%1: %2 shells lie within another one and are taken as the walls of hollows.</source>
        <translation>%1：別の殻の内側にある殻 %2 個は空洞の壁とみなします。</translation>
    </message>
    <message>
        <source>%1: %2 triangles cross others by %3 mm at most; they are left as they are.</source>
        <translation>%1：三角形 %2 個が他と最大 %3 mm 交差していますが、そのままにします。</translation>
    </message>
    <message>
        <source>%1: line %2 was not understood and passed over; it begins with %3.</source>
        <translation>%1：%2 行目は解釈できず、読み飛ばしました（%3 で始まる行）。</translation>
    </message>
    <message>
        <source>%1: %2 lines were not understood and passed over; the first is line %3, which begins with %4.</source>
        <translation>%1：%2 行は解釈できず、読み飛ばしました。最初は %3 行目で、%4 で始まります。</translation>
    </message>
    <message>
        <source>%1: the surface lies too far from zero for single precision: %2, %3, %4 were subtracted from its coordinates before they were rounded.</source>
        <translation>%1：表面が原点から遠く、単精度では足りないため、丸める前に座標から %2、%3、%4 を引きました。</translation>
    </message>
    <message>
        <source>No enamel is given: what no other layer holds is taken as enamel.</source>
        <translation>エナメル質が与えられていません。どの層にも含まれない部分をエナメル質とします。</translation>
    </message>
    <message>
        <source>The whole tooth is taken as enamel, as chosen.</source>
        <translation>指定により歯全体をエナメル質とします。</translation>
    </message>
    <message>
        <source>Only the outer surface is known: enamel and dentin are a model, with enamel up to %1 mm thick that thins to nothing at the neck. They are no measurement of this tooth.</source>
        <translation>外表面だけが分かっています。エナメル質と象牙質はモデルで、エナメル質は最大 %1 mm、歯頸部に向かって薄くなります。この歯の実測ではありません。</translation>
    </message>
    <message>
        <source>The pulp is a model, too: a chamber at the neck and a canal down each root.</source>
        <translation>歯髄もモデルです。歯頸部の髄室と各歯根の根管からなります。</translation>
    </message>
    <message>
        <source>The surface encloses a hollow: it is taken as the pulp space, which is empty.</source>
        <translation>表面は空洞を囲んでいます。これを歯髄腔とみなし、空とします。</translation>
    </message>
    <message>
        <source>The material '%1' of this tooth is not known here: it is felt, cut, seen and heard as bone. Give the file of its materials (--materials).</source>
        <translation>この歯の材料「%1」はここでは未知です。触感、切削、表示、音は骨として扱います。材料のファイルを指定してください（--materials）。</translation>
    </message>
    <message>
        <source>There is no room for a pulp: the tooth has none.</source>
        <translation>歯髄の入る余地がないため、この歯に歯髄はありません。</translation>
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
        <source>What was assumed, and what was mended:</source>
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
</context>
<context>
    <name>tactooth::ExercisePanel</name>
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
        <source>How often the work of a tick, and its waking up, took so long. What reaches the dashed line costs the hand a tick.</source>
        <translation>1 周期の計算と起床の遅れがそれぞれどれだけの時間を要したかの頻度です。破線に達すると、手は 1 周期ぶんの力を失います。</translation>
    </message>
    <message>
        <source>work of a tick, µs</source>
        <translation>1 周期の計算、µs</translation>
    </message>
    <message>
        <source>woken late, µs</source>
        <translation>起床の遅れ、µs</translation>
    </message>
    <message>
        <source>period off by, µs</source>
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
        <source>Forgets all ticks so far, as those while the program started</source>
        <translation>プログラムの起動時のものなど、これまでの周期を忘れます</translation>
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
        <source>work of a tick</source>
        <translation>1 周期の計算</translation>
    </message>
    <message>
        <source>woken late</source>
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
</TS>
