#!/usr/bin/env bash
# A PostgreSQL server of the distribution's package, for a test: on a socket in DIR and on a port of
# loopback, until the calling process ends or DIR/server.pid is stopped.
#   postgres_server.sh DIR     a directory to make; becomes the server, in the foreground.
# DIR/uri is the connection string of its owner, with a password, and is written before it starts.
# Exit status 77: PostgreSQL's server is not installed.
set -euo pipefail
directory=$1
initdb=$(find /usr/lib/postgresql -name initdb 2>/dev/null | sort -V | tail -n 1)
[ -n "$initdb" ] || { echo "no initdb here: PostgreSQL's server is not installed" >&2; exit 77; }

mkdir -m 700 "$directory"
echo 'p@ss: wörd/?#' >"$directory/password"
as_owner=(setpriv --pdeathsig INT)
if [ "$(id -u)" -eq 0 ]; then  # which initdb refuses
  getent passwd postgres >/dev/null || { echo "no user postgres here" >&2; exit 77; }
  chown -R postgres: "$directory"
  as_owner=(setpriv --reuid postgres --regid postgres --init-groups --pdeathsig INT)
fi
cd "$directory"
"${as_owner[@]}" "$initdb" -D data -U tribolog -E UTF8 --locale=C -A scram-sha-256 \
  --pwfile=password --no-sync >initdb.log 2>&1 || { cat initdb.log >&2; exit 1; }
port=$((20000 + RANDOM % 30000))
while (: <>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do port=$((port + 1)); done
echo "postgresql://tribolog:p%40ss%3A%20w%C3%B6rd%2F%3F%23@127.0.0.1:$port/postgres" >uri.new
mv uri.new uri
echo $$ >server.pid
exec "${as_owner[@]}" "${initdb%/*}/postgres" -D data -k "$directory" -p "$port" \
  -c listen_addresses=127.0.0.1 >server.log 2>&1
