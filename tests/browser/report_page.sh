#!/bin/sh
# Opens the made-up lot's report in headless Chromium and fails on what a reader would stumble over: script errors,
# figures that are not drawn, a page wider than the window, a request to the network, markup of the input coming alive.
#   report_page.sh MAKE_PAGE [CHROMIUM]
# ISOLAW_SCREENSHOTS=DIR keeps pictures of every case.
set -u
make_page=$1
chromium=${2:-}
if [ -z "$chromium" ] || ! [ -x "$chromium" ]; then
  echo "skipped: no Chromium found (install chromium, or configure with -DISOLAW_CHROMIUM=FILE)"
  exit 77
fi
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0

browse() {  # flags and URL
  timeout 120 "$chromium" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking \
    --disable-component-update --disable-sync --hide-scrollbars --user-data-dir="$work/profile" "$@" 2>>"$work/browser.log"
}

expect() {  # case, what the page must have reported, meaning
  if ! printf '%s' "$seen" | grep -q -F -- "$2"; then
    echo "FAILED $1: $3 (no $2)"
    failed=1
  fi
}

# case, devices, laws, width, height, plots, paper colour, further flags
check() {
  name=$1 devices=$2 laws=$3 width=$4 height=$5 plots=$6 paper=$7
  shift 7
  "$make_page" "$work/$name" "$devices" "$laws" >"$work/ranking.txt" || { echo "FAILED $name: make_page"; failed=1; return; }
  { cat "$work/$name/report.html"; printf '<script>'; cat "$here/probe.js"; printf '</script>'; } >"$work/$name/probed.html"
  cat >"$work/$name/frame.html" <<END
<!doctype html><body style="margin:0"><iframe src="probed.html" style="border:0;width:${width}px;height:${height}px"></iframe>
<pre id="seen"></pre><script>addEventListener('message', (event) => { document.getElementById('seen').textContent = event.data; });</script>
END
  window=$width
  [ "$window" -lt 500 ] && window=500  # the browser's own smallest window
  seen=$(browse --virtual-time-budget=60000 --window-size="$window,$height" "$@" --dump-dom "file://$work/$name/frame.html" |
    sed -n 's/.*<pre id="seen">\(.*\)<\/pre>.*/\1/p')
  echo "$name: $seen"
  expect "$name" '"errors":""' "script errors"
  expect "$name" "\"plots\":$plots,\"drawn\":$plots," "figures that are not drawn"
  expect "$name" "\"printed\":$plots" "figures that are not drawn for printing"
  expect "$name" '"wide":[],"scrolls":false' "wider than the window"
  expect "$name" '"images":0,"requests":[]' "something was loaded"
  expect "$name" "\"paper\":\"$paper\"" "colours"
  if [ -n "${ISOLAW_SCREENSHOTS:-}" ]; then
    mkdir -p "$ISOLAW_SCREENSHOTS"
    sed -i 's/probed.html/report.html/' "$work/$name/frame.html"
    browse --virtual-time-budget=8000 --window-size="$window,$height" "$@" --screenshot="$ISOLAW_SCREENSHOTS/$name.png" "file://$work/$name/frame.html"
  fi
}

white='rgb(255, 255, 255)'
black='rgb(20, 25, 29)'
check laptop 3 3 1366 768 5 "$white"
check dark 3 7 1366 768 5 "$black" --blink-settings=preferredColorScheme=0
check phone 10 7 390 844 5 "$white"
check one-device 1 3 1366 768 5 "$white"
check large-lot 160 7 1366 768 5 "$white"
[ "$failed" -eq 0 ] && echo "the report opens, draws and fits in every case"
exit "$failed"
