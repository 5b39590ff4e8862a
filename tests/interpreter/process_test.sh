#!/bin/sh
# The command as a process: signals, pipes, a full disk. Usage: process_test.sh UDCP; prints what failed and exits with 1.
udcp=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
failed=0
fail() { echo "FAILED: $1"; failed=1; }
expect_code() { [ "$1" -eq "$2" ] || fail "$3: exit code $1 instead of $2"; }

# A program from a pipe, and from standard input at its end.
[ "$(echo '1/3 + 1/6' | "$udcp")" = "1/2" ] || fail "program from a pipe"
"$udcp" < /dev/null; expect_code $? 0 "empty program"

# A reader that goes away ends the command quietly.
i=0; while [ $i -lt 5000 ]; do echo "$i"; i=$((i + 1)); done > "$folder/many.udcp"
{ "$udcp" "$folder/many.udcp" 2> "$folder/err"; echo $? > "$folder/code"; } | head -n 1 > /dev/null
[ -s "$folder/err" ] && fail "a closed pipe: $(head -n 1 "$folder/err")"
code=$(cat "$folder/code")
[ "$code" -eq 141 ] || [ "$code" -eq 0 ] || fail "a closed pipe: exit code $code"

# A full disk is a file error.
if [ -w /dev/full ]; then
  "$udcp" -e '1' > /dev/full 2> "$folder/err"; expect_code $? 5 "full disk"
  grep -q 'error\[F' "$folder/err" || fail "full disk: no message"
fi

# Ctrl-C: 130, the old file as it was, no temporary left.
echo "old" > "$folder/out.obj"
"$udcp" -e "cube() |> ((UCP)*)^10 |> save \"$folder/out.obj\"" > /dev/null 2> "$folder/err" &
pid=$!
sleep 0.3
kill -INT $pid
wait $pid; expect_code $? 130 "interrupt"
grep -q 'error\[I01\]' "$folder/err" || fail "interrupt: no message: $(cat "$folder/err")"
[ "$(cat "$folder/out.obj")" = "old" ] || fail "interrupt: the old file was touched"
[ "$(ls "$folder" | wc -l)" -eq 4 ] || fail "interrupt: left behind $(ls "$folder")"

# A missing file, a syntax error, a false assertion.
"$udcp" "$folder/none.udcp" 2> /dev/null; expect_code $? 5 "missing file"
"$udcp" -e '(1' 2> /dev/null; expect_code $? 2 "syntax error"
"$udcp" -e 'assert 1 == 2' > /dev/null; expect_code $? 1 "false assertion"
exit $failed
