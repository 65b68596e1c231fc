"""A studio for tests: Front(program, folder, model) starts `sanggwan serve`;
front.page() is a page's socket: page.ask("view", ...) -> (head, body)."""
import base64
import http.client
import json
import os
import signal
import socket
import struct
import subprocess


class Refused(Exception):
    """The front does not open the socket: the status."""


class Front:
    def __init__(self, program, folder, model=None, arguments=(), env=None,
                 port=None, path=None):
        self.path = path
        self.process = subprocess.Popen(
            [program, "serve", "--no-open",
             *([model] if model else []), *arguments,
             *(["--port", str(port)] if port else []),
             *(["--socket", path] if path else [])],
            cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, env=env)
        self.address = self.process.stdout.readline().decode().strip()
        place, self.token = self.address.split("/#")
        if path:
            self.host, port = place.split("/")[2], 80
        elif port is None:
            self.host, port = place[len("http://"):].split(":")
        else:
            self.host = "127.0.0.1"
        self.port = int(port)

    def get(self, path, method="GET", headers=None, body=None):
        """status, headers, octets"""
        connection = http.client.HTTPConnection("127.0.0.1", self.port,
                                                timeout=20)
        given = {"Host": "%s:%d" % (self.host, self.port)}
        given.update(headers or {})
        if self.path:
            connection.sock = self.connected()
        connection.request(method, path, body, given)
        answer = connection.getresponse()
        octets = answer.read()
        connection.close()
        return answer.status, dict(answer.getheaders()), octets

    def connected(self):
        if self.path is None:
            out = socket.create_connection(("127.0.0.1", self.port), 30)
            out.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            return out
        out = socket.socket(socket.AF_UNIX)
        out.settimeout(30)
        out.connect(self.path)
        return out

    def socket(self, **headers):
        return Socket(self, headers)

    def page(self):
        page = self.socket()
        page.say({"id": 0, "do": "hello", "token": self.token})
        page.hello, _ = page.hear()
        return page

    def sessions(self):
        """The processes of the sessions."""
        listed = subprocess.run(["pgrep", "-P", str(self.process.pid)],
                                stdout=subprocess.PIPE, check=False)
        return [int(word) for word in listed.stdout.split()]

    def end(self, by=signal.SIGINT):
        self.process.send_signal(by)
        out, error = self.process.communicate(timeout=20)
        return self.process.returncode, out, error


class Socket:
    """A websocket, as a browser has it."""

    def __init__(self, front, headers):
        self.socket = front.connected()
        place = "%s:%d" % (front.host, front.port)
        given = {"Host": place, "Origin": "http://" + place,
                 "Upgrade": "websocket", "Connection": "Upgrade",
                 "Sec-WebSocket-Version": "13", "Sec-WebSocket-Key":
                 base64.b64encode(os.urandom(16)).decode()}
        given.update({name.replace("_", "-"): value
                      for name, value in headers.items()})
        head = "GET /ws HTTP/1.1\r\n" + "".join(
            "%s: %s\r\n" % pair for pair in given.items()
            if pair[1] is not None) + "\r\n"
        self.socket.sendall(head.encode())
        self.rest = b""
        answer = b""
        while b"\r\n\r\n" not in answer:
            octets = self.socket.recv(4096)
            if not octets:
                raise Refused(answer)
            answer += octets
        line, self.rest = answer.split(b"\r\n", 1)[0], answer.split(
            b"\r\n\r\n", 1)[1]
        status = int(line.split()[1])
        if status != 101:
            raise Refused(status)
        self.number = 0
        self.events = []

    def exactly(self, n):
        while len(self.rest) < n:
            octets = self.socket.recv(65536)
            if not octets:
                raise EOFError
            self.rest += octets
        octets, self.rest = self.rest[:n], self.rest[n:]
        return octets

    def frame(self, opcode, octets, final=True, claimed=None):
        """Sends a frame, which says it has `claimed` octets."""
        n = len(octets) if claimed is None else claimed
        head = bytes([(0x80 if final else 0) | opcode])
        if n < 126:
            head += bytes([0x80 | n])
        elif n < 65536:
            head += bytes([0x80 | 126]) + struct.pack(">H", n)
        else:
            head += bytes([0x80 | 127]) + struct.pack(">Q", n)
        mask = os.urandom(4)
        masked = (int.from_bytes(octets, "big") ^ int.from_bytes(
            (mask * (len(octets) // 4 + 1))[:len(octets)], "big")
                  ).to_bytes(len(octets), "big")
        self.socket.sendall(head + mask + masked)

    def say(self, head):
        self.frame(1, json.dumps(head).encode())

    def message(self):
        """opcode, octets"""
        first, second = self.exactly(2)
        n = second & 127
        if n == 126:
            n, = struct.unpack(">H", self.exactly(2))
        elif n == 127:
            n, = struct.unpack(">Q", self.exactly(8))
        return first & 15, self.exactly(n)

    def hear(self):
        """head, body of what the page hears next; the code of a close."""
        while True:
            opcode, octets = self.message()
            if opcode == 8:
                return struct.unpack(">H", octets[:2])[0], b""
            if opcode == 2:
                h, = struct.unpack(">I", octets[:4])
                return json.loads(octets[4:4 + h]), octets[4 + h:]

    def ask(self, do, **keys):
        self.number += 1
        self.say(dict(keys, id=self.number, do=do))
        while True:
            head, body = self.hear()
            if isinstance(head, int):
                raise EOFError(head)
            if head.get("id") == self.number and "progress" not in head:
                return head, body
            self.events.append(head)

    def close(self):
        self.socket.close()
