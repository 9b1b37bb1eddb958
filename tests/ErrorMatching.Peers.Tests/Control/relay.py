"""Makes a TCP port of these name spaces reachable from outside, by a socket in a folder.

usage: relay.py SOCKET PORT
"""
import socket
import sys
import threading


def pump(source, target):
    try:
        while data := source.recv(65536):
            target.sendall(data)
    except OSError:
        pass
    for end in (source, target):
        try:
            end.shutdown(socket.SHUT_RDWR)
        except OSError:
            pass


server = socket.socket(socket.AF_UNIX)
server.bind(sys.argv[1])
server.listen(16)
while True:
    client, _ = server.accept()
    try:
        line = socket.create_connection(("127.0.0.1", int(sys.argv[2])))
    except OSError:
        client.close()
        continue
    threading.Thread(target=pump, args=(client, line), daemon=True).start()
    threading.Thread(target=pump, args=(line, client), daemon=True).start()
