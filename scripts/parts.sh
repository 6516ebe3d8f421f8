# shellcheck shell=bash
# Sourced by what runs in parts: each has a name and a time, and what failed is the last thing said.
#
#     . scripts/parts.sh
#     part NAME COMMAND...   runs a command or function; its status. Results in JUnit's XML belong into
#                            "$results". 77: it could not run, for the reason that it said last.
#     end_of_parts           prints the summary of all parts (scripts/summary.py), and exits: 1 where one failed
#
# A script that another one calls adds its parts to the summary of that one, with names that begin with
# GRADMESH_PARTS_OF. With `quiet=1` a part's output is kept for the summary, and its line alone is shown.
if [ -z "${GRADMESH_PARTS:-}" ]; then
  GRADMESH_PARTS=$(mktemp -d)
  export GRADMESH_PARTS
  outermost=1
fi
failed=0

part() {
  local name="${GRADMESH_PARTS_OF:-}$1" start=$SECONDS status
  shift
  # The command sees it, also where that is a function.
  local results="$GRADMESH_PARTS/$name.xml"
  if [ "${quiet:-}" ]; then
    "$@" >"$GRADMESH_PARTS/$name.log" 2>&1 && status=0 || status=$?
  else
    echo "== $name"
    { "$@" 2>&1 && status=0 || status=$?; echo "$status" >"$GRADMESH_PARTS/$name.status"; } | tee "$GRADMESH_PARTS/$name.log"
    status=$(<"$GRADMESH_PARTS/$name.status")
  fi
  printf '%s\t%d\t%d\n' "$name" "$status" $((SECONDS - start)) >>"$GRADMESH_PARTS/parts.tsv"
  if [ "${quiet:-}" ]; then
    /usr/bin/python3 scripts/summary.py "$GRADMESH_PARTS" --last
  fi
  [ "$status" -eq 0 ] || [ "$status" -eq 77 ] || failed=1
  return "$status"
}

end_of_parts() {
  if [ "${outermost:-}" ]; then
    /usr/bin/python3 scripts/summary.py "$GRADMESH_PARTS" ${quiet:+--rest} || failed=1
    rm -rf "$GRADMESH_PARTS"
  fi
  exit $failed
}
