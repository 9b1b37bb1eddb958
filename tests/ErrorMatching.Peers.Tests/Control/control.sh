#!/bin/bash
# Starts LinuxCNC without a screen and without real time. The caller gives it name spaces of its own (unshare --pid --ipc --net), so that
# several can run, and all its parts end with the first process.
#
# usage: control.sh HOME    HOME has control.ini, control.hal, relay.py, touch.py and slot.json; the line server is then at HOME/line.
set -u
cd "$1" || exit 1
export HOME="$1" RTAPI_UID=65534 RTAPI_FIFO_PATH="$1/rtapi_fifo"
ini="$1/control.ini"
printf 'T1 P1 D6 Z0 ;mill\nT2 P2 D3 Z0 ;probe\n' >tool.tbl
ip link set lo up
/usr/lib/linuxcnc/realtime start
linuxcncsvr -ini "$ini" &
sleep 0.2
halcmd loadusr -Wn iocontrol io -ini "$ini" || exit 1
halcmd -i "$ini" -f control.hal || exit 1
milltask -ini "$ini" &
sleep 0.3
halcmd start
linuxcncrsh -- -ini "$ini" &
python3 relay.py "$1/line" 5007 &

# The path that the servo loop commands, from now on.
halsampler -t >"$1/path.txt" 2>"$1/path.log" &
for _ in $(seq 300); do
    if [ -S line ] && (echo >/dev/tcp/127.0.0.1/5007) 2>/dev/null; then break; fi
    sleep 0.1
done
touch "$1/ready"
wait
