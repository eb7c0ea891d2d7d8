// SPDX-FileCopyrightText: 2026 The Tactooth authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/util/message.h"

/// The catalogue of this layer: what it says to people, in both languages.
namespace tactooth::msg {

// Choosing a device.
inline constexpr MessageText kUnknownDevice{
    "unknown_device", "%1 takes %2, or replay:FILE.csv, not '%3'; 'tactooth devices' shows what is there.",
    "%1 に '%3' は指定できません。%2、または replay:FILE.csv を指定してください。'tactooth devices' "
    "で接続中の装置が分かります。"};
inline constexpr MessageText kDeviceChoice{"device_choice", "%1, %2 or %3 for one of several",
                                           "%1、複数あるうちの一つなら %2 か %3"};
inline constexpr MessageText kUnknownPedal{
    "unknown_pedal",
    "'%1' is not a pedal: give axis:N or button:N of a joystick (N from 0 to 31), with :NAME of the joystick "
    "behind it if there are several.",
    "'%1' はペダルではありません。ジョイスティックの axis:N か button:N（N は 0～31）で書き、"
    "複数あるときは後ろに :NAME を付けてください。"};

// Gamepads and joysticks.
inline constexpr MessageText kNoGamepad{
    "no_gamepad", "There is no gamepad: plug one in or switch it on, and see that you may read /dev/input.",
    "ゲームパッドが見つかりません。接続するか電源を入れ、/dev/input を読む権限を確かめてください。"};
inline constexpr MessageText kNoGamepadNamed{
    "no_gamepad_named",
    "There is no gamepad named '%1': plug one in or switch it on, and see that you may read /dev/input.",
    "ゲームパッド「%1」が見つかりません。接続するか電源を入れ、/dev/input を読む権限を確かめてください。"};
inline constexpr MessageText kGamepadInUse{
    "gamepad_in_use", "A gamepad steers already; there is one for each program.",
    "ゲームパッドはすでに使われています。使えるのは一つのプログラムにつき1台です。"};
inline constexpr MessageText kGamepadUnplugged{
    "gamepad_unplugged", "The gamepad has been unplugged: plug it in again, and the session goes on.",
    "ゲームパッドが外れました。もう一度接続すれば、そのまま続けられます。"};
inline constexpr MessageText kJoysticksNotRead{"joysticks_not_read", "Joysticks cannot be read (%1).",
                                               "ジョイスティックを読めません（%1）。"};

// SpaceMouse.
inline constexpr MessageText kSpaceMouseInUse{
    "space_mouse_in_use", "A SpaceMouse steers already; there is one for each program.",
    "SpaceMouseはすでに使われています。使えるのは一つのプログラムにつき1台です。"};
inline constexpr MessageText kSpaceMouseNoDriver{
    "space_mouse_no_driver",
    "The SpaceMouse's driver does not run: install spacenavd, start it (sudo systemctl start spacenavd) and plug "
    "the SpaceMouse in.",
    "SpaceMouseのドライバーが動いていません。spacenavdをインストールして起動し（sudo systemctl start "
    "spacenavd）、SpaceMouseを接続してください。"};
inline constexpr MessageText kSpaceMouseLost{
    "space_mouse_lost",
    "The SpaceMouse's driver has stopped: start it again (sudo systemctl start spacenavd), and the session goes "
    "on.",
    "SpaceMouseのドライバーが止まりました。もう一度起動すれば（sudo systemctl start spacenavd）、"
    "そのまま続けられます。"};

// A library that is tried in a child process.
inline constexpr MessageText kNoPipe{"no_pipe", "no pipe: %1", "パイプを作れません：%1"};
inline constexpr MessageText kNoChildProcess{"no_child_process", "no child process: %1", "子プロセスを作れません：%1"};
inline constexpr MessageText kDoesNotReturn{"does_not_return", "it does not return", "応答が戻りません"};
inline constexpr MessageText kCrashes{"crashes", "it crashes (%1)", "クラッシュします: %1"};
inline constexpr MessageText kClosesWhatIsNotItsOwn{"closes_what_is_not_its_own", "it closes what it has not opened",
                                                    "自分で開いていないものを閉じます"};
inline constexpr MessageText kEndsTheProgram{"ends_the_program", "it ends the program that uses it",
                                             "呼び出したプログラムを終了させます"};

// OpenHaptics.
inline constexpr MessageText kLibraryBroken{
    "library_broken", "%1 is broken, %2: install the device's driver anew; Tactooth leaves it alone.",
    "%1 は壊れています（%2）。デバイスのドライバーを入れ直してください。Tactooth はこのライブラリを使いません。"};
inline constexpr MessageText kLibraryNotLoaded{
    "library_not_loaded",
    "%1 cannot be loaded (%2): install the device's driver and OpenHaptics, or set TACTOOTH_LIBHD to the library.",
    "%1 を読み込めません（%2）。装置のドライバーとOpenHapticsをインストールするか、TACTOOTH_LIBHD "
    "にライブラリの場所を設定してください。"};
inline constexpr MessageText kLibraryLacksFunction{
    "library_lacks_function", "%1 has no function %2: it is another version; install OpenHaptics 3.4 or newer.",
    "%1 に関数 %2 がありません。バージョンが違います。OpenHaptics 3.4 以降をインストールしてください。"};
inline constexpr MessageText kPenFailed{"pen_failed", "OpenHaptics, %1: %2", "OpenHaptics、%1：%2"};
inline constexpr MessageText kDefaultDevice{"default_device", "the default device", "標準の装置"};
inline constexpr MessageText kDeviceNamed{"device_named", "the device '%1'", "装置「%1」"};
inline constexpr MessageText kPenUnknown{
    "pen_unknown", "OpenHaptics knows no device for %1: look its name up in the vendor's setup program.",
    "OpenHapticsに%1が登録されていません。メーカーの設定プログラムで名前を確かめてください。"};
inline constexpr MessageText kPenNotConfigured{
    "pen_not_configured",
    "OpenHaptics knows no device for %1: choose one that is set up (%2), or set it up in the vendor's setup "
    "program.",
    "OpenHapticsに%1が登録されていません。登録済みの装置（%2）から選ぶか、"
    "メーカーの設定プログラムで登録してください。"};
inline constexpr MessageText kPensInUse{"pens_in_use",
                                        "OpenHaptics: four devices are in use already; close one of them.",
                                        "OpenHaptics：すでに4台の装置が使用中です。1台を閉じてください。"};
inline constexpr MessageText kHdMotorsWarm{
    "hd_motors_warm", "The motors are warm: rest the pen for a minute; until then the force is weaker.",
    "モーターが熱くなっています。ペンを1分ほど休ませてください。それまで力は弱くなります。"};
inline constexpr MessageText kHdTooMuchForce{"hd_too_much_force",
                                             "The driver has cut a force that was too strong; press more gently.",
                                             "強すぎる力をドライバーが制限しました。もっと軽く押してください。"};
inline constexpr MessageText kHdTooMuchImpulse{
    "hd_too_much_impulse", "The driver has cut a force that rose too fast; move the pen more slowly into the tooth.",
    "急すぎる力をドライバーが制限しました。ペンをもっとゆっくり歯に近づけてください。"};
inline constexpr MessageText kHdTooFast{
    "hd_too_fast", "The pen was moved faster than its driver allows; the force comes back by itself.",
    "ドライバーが許すより速くペンが動かされました。力は自動的に戻ります。"};
inline constexpr MessageText kHdForceError{"hd_force_error",
                                           "The driver reports a force error: switch the device off and on again.",
                                           "ドライバーが力のエラーを報告しています。装置の電源を入れ直してください。"};
inline constexpr MessageText kHdDeviceFault{
    "hd_device_fault", "The device reports a fault: check its power supply and cable, then switch it off and on again.",
    "装置が故障を報告しています。電源とケーブルを確かめ、電源を入れ直してください。"};
inline constexpr MessageText kHdAlreadyStarted{"hd_already_started",
                                               "The device is in use: close the other program that holds it.",
                                               "装置は使用中です。装置を使っている他のプログラムを閉じてください。"};
inline constexpr MessageText kHdLinkFault{
    "hd_link_fault", "The device does not answer: check its cable and power supply; it is tried again every second.",
    "装置が応答しません。ケーブルと電源を確かめてください。1秒ごとに再試行します。"};
inline constexpr MessageText kHdLinkSettings{
    "hd_link_settings", "The device is not set up: run the vendor's setup program and pair it.",
    "装置が設定されていません。メーカーの設定プログラムでペアリングしてください。"};
inline constexpr MessageText kHdTimer{
    "hd_timer", "The driver's timer does not run: start the vendor's service, or restart the computer.",
    "ドライバーのタイマーが動いていません。メーカーのサービスを起動するか、コンピューターを再起動してください。"};
inline constexpr MessageText kHdSchedulerFull{
    "hd_scheduler_full", "The driver takes no more work: close other programs that use the device.",
    "ドライバーがこれ以上受け付けません。装置を使う他のプログラムを閉じてください。"};
inline constexpr MessageText kHdNoLicence{
    "hd_no_licence", "The vendor's library finds no licence: install OpenHaptics with its licence.",
    "メーカーのライブラリにライセンスが見つかりません。OpenHapticsをライセンスとともにインストールしてください。"};
inline constexpr MessageText kHdOtherError{
    "hd_other_error", "The device's driver reports an error: switch the device off and on again and restart Tactooth.",
    "装置のドライバーがエラーを報告しています。装置の電源を入れ直し、Tactoothを再起動してください。"};
inline constexpr MessageText kHdFlood{
    "hd_flood",
    "The device's driver calls far too often, so the force is off: restart the vendor's service, or the computer.",
    "装置のドライバーの呼び出しが多すぎるため、力を切りました。"
    "メーカーのサービスかコンピューターを再起動してください。"};
inline constexpr MessageText kHdDockPen{
    "hd_dock_pen", "Put the pen into its inkwell for a moment, so that the device can find its position.",
    "装置が位置を覚えるように、ペンを少しの間インクウェルに差し込んでください。"};
inline constexpr MessageText kHdSilent{
    "hd_silent",
    "The device has stopped answering: check its cable and power supply; the session goes on when it is back.",
    "装置の応答が止まりました。ケーブルと電源を確かめてください。戻ればそのまま続けられます。"};

// Inverse3.
inline constexpr MessageText kHaplyNotThere{
    "haply_not_there",
    "The Haply Inverse Service does not answer at %1: install and start it, or set TACTOOTH_HAPLY to where it "
    "listens.",
    "Haply Inverse Serviceが %1 で応答しません。インストールして起動するか、TACTOOTH_HAPLY "
    "に待ち受け先を設定してください。"};
inline constexpr MessageText kHaplyIsAnother{
    "haply_is_another",
    "What answers at %1 is not the Haply Inverse Service: end that program, or set TACTOOTH_HAPLY to where the "
    "service listens.",
    "%1 で応答しているのはHaply Inverse Serviceではありません。そのプログラムを終了するか、TACTOOTH_HAPLY "
    "に待ち受け先を設定してください。"};
inline constexpr MessageText kHaplySaysNothing{
    "haply_says_nothing", "The Haply Inverse Service at %1 does not list its devices: restart it.",
    "%1 の Haply Inverse Serviceが接続中の装置を知らせません。再起動してください。"};
inline constexpr MessageText kHaplyNoInverse3{
    "haply_no_inverse3", "The Haply Inverse Service finds no Inverse3: check its cable and power supply.",
    "Haply Inverse ServiceがInverse3を見つけられません。ケーブルと電源を確かめてください。"};
inline constexpr MessageText kHaplyUnknownInverse3{
    "haply_unknown_inverse3", "The Haply Inverse Service knows no Inverse3 '%1': it finds %2.",
    "Haply Inverse Serviceに Inverse3 '%1' がありません。見つかったのは %2 です。"};
inline constexpr MessageText kHaplySlow{
    "haply_slow", "The Haply Inverse Service answers too slowly: close other programs that keep this machine busy.",
    "Haply Inverse Serviceの応答が遅すぎます。コンピューターに負荷をかけている他のプログラムを閉じてください。"};
inline constexpr MessageText kHaplyTooManyAnswers{
    "haply_too_many_answers",
    "The Haply Inverse Service sends more answers than it is asked for, so the force is off: restart the service.",
    "Haply Inverse Serviceが問い合わせより多くの応答を送ってくるため、力を切りました。"
    "サービスを再起動してください。"};
inline constexpr MessageText kHaplyLost{
    "haply_lost",
    "The Haply Inverse Service has closed the connection: start it again; it is tried again every second.",
    "Haply Inverse Serviceが接続を閉じました。もう一度起動してください。1秒ごとに再試行します。"};
inline constexpr MessageText kHaplyNoAnswer{
    "haply_no_answer", "The Haply Inverse Service has stopped answering: restart it; it is tried again every second.",
    "Haply Inverse Serviceの応答が止まりました。再起動してください。1秒ごとに再試行します。"};
inline constexpr MessageText kHaplyNoJson{
    "haply_no_json",
    "The Haply Inverse Service sends messages that cannot be read: restart it; if that does not help, install it anew.",
    "Haply Inverse Serviceから正しくない通信が届きました。再起動し、"
    "それでも直らなければ再インストールしてください。"};
inline constexpr MessageText kHaplyOtherVersion{
    "haply_other_version", "The Haply Inverse Service uses another version of its protocol: install version 3.",
    "Haply Inverse Serviceの通信のバージョンが違います。バージョン3をインストールしてください。"};
inline constexpr MessageText kHaplyOtherUnits{
    "haply_other_units", "The Haply Inverse Service reports positions that are not in metres: install version 3 of it.",
    "Haply Inverse Serviceの位置の単位がメートルではありません。バージョン3をインストールしてください。"};
inline constexpr MessageText kInverse3Lost{
    "inverse3_lost",
    "The Inverse3 has lost its position: put its arms into their rest position and switch it off and on "
    "again.",
    "Inverse3の位置が分かりません。アームを休止位置に置き、電源を入れ直してください。"};
inline constexpr MessageText kInverse3Gone{
    "inverse3_gone", "The Inverse3 is gone: check its cable and power supply; the session goes on when it is back.",
    "Inverse3が見つからなくなりました。ケーブルと電源を確かめてください。戻ればそのまま続けられます。"};
inline constexpr MessageText kInverse3NoPower{"inverse3_no_power",
                                              "The Inverse3 has no power: plug in its power supply.",
                                              "Inverse3に電源が来ていません。電源をつないでください。"};
inline constexpr MessageText kInverse3NotCalibrated{
    "inverse3_not_calibrated",
    "The Inverse3 is not calibrated: hold its arms in their rest position until its light stays on.",
    "Inverse3が校正されていません。ランプが点灯したままになるまでアームを休止位置に保ってください。"};
inline constexpr MessageText kInverse3NotReady{
    "inverse3_not_ready", "The Inverse3 is not ready: wait for its light, or switch it off and on again.",
    "Inverse3の準備ができていません。ランプを待つか、電源を入れ直してください。"};
inline constexpr MessageText kGripAsleep{"grip_asleep", "The VerseGrip is asleep: press one of its buttons.",
                                         "VerseGripがスリープしています。ボタンを一つ押してください。"};
inline constexpr MessageText kGripBroken{
    "grip_broken",
    "The VerseGrip reports an orientation that is not valid: switch it off and on again if this happens again.",
    "VerseGripの向きが正しい値になっていません。繰り返すときは電源を入れ直してください。"};

// Poses that no hand can have.
inline constexpr MessageText kPoseNotANumber{
    "pose_not_a_number",
    "The device reports a position that is not a number: switch it off and on again if this happens again.",
    "装置の位置が数値になっていません。繰り返すときは電源を入れ直してください。"};
inline constexpr MessageText kPoseInvalidRotation{
    "pose_invalid_rotation",
    "The device reports an orientation that is not valid: switch it off and on again if this happens again.",
    "装置の向きが正しい値になっていません。繰り返すときは電源を入れ直してください。"};
inline constexpr MessageText kPoseJump{
    "pose_jump", "The device's position has jumped: check its cable, and calibrate it if this happens again.",
    "装置の位置が飛びました。ケーブルを確かめ、繰り返すときは校正してください。"};
inline constexpr MessageText kPoseTooFast{
    "pose_too_fast",
    "The device moved faster than 1.5 m/s at the tooth, so its force is off: lift the bur, and check the cable "
    "if the hand was slow.",
    "歯に触れている間に装置が毎秒1.5 mより速く動いたため、力を切りました。バーを歯から離してください。"
    "手がゆっくりだったときは、ケーブルを確かめてください。"};
inline constexpr MessageText kPoseRotatesTooFast{
    "pose_rotates_too_fast", "The device's orientation has jumped: switch it off and on again if this happens again.",
    "装置の向きが飛びました。繰り返すときは電源を入れ直してください。"};
inline constexpr MessageText kPoseStale{
    "pose_stale", "The device's positions come too late: close other programs that keep this machine busy.",
    "装置の位置が遅れて届いています。コンピューターに負荷をかけている他のプログラムを閉じてください。"};
inline constexpr MessageText kPoseForce{
    "pose_force",
    "The computed force was not a number, so the force is off: lift the bur, and report it to the authors if "
    "this happens again.",
    "力が数値にならなかったため、力を切りました。バーを歯から離してください。"
    "繰り返すときは作者に知らせてください。"};

// Kinds of devices.
inline constexpr MessageText kMouseAndKeyboard{"mouse_and_keyboard", "Mouse and keyboard", "マウスとキーボード"};
inline constexpr MessageText kHapticPen{"haptic_pen", "Haptic pen (OpenHaptics)", "力覚ペン（OpenHaptics）"};
inline constexpr MessageText kNamedHapticPen{"named_haptic_pen", "Haptic pen %1", "力覚ペン %1"};
inline constexpr MessageText kHaplyInverse3{"haply_inverse3", "Haply Inverse3", "Haply Inverse3"};  // a name
inline constexpr MessageText kGamepad{"gamepad", "Gamepad", "ゲームパッド"};
inline constexpr MessageText kSpaceMouse{"space_mouse", "SpaceMouse", "SpaceMouse"};  // a name

}  // namespace tactooth::msg
