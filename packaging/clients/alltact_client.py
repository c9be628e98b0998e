"""What `alltact serve` sends, in thirty lines: python3 alltact_client.py SOCKET [PART...] (alltact serve --schema tells all)."""
import json, socket, struct, sys
import numpy as np

TYPES = {1: "finger", 2: "frame", 3: "problem", 4: "end", 5: "refused"}


def exactly(connection: socket.socket, size: int) -> bytearray:
    data = bytearray(size)
    view = memoryview(data)
    while view:
        if not (count := connection.recv_into(view)):
            raise EOFError("the server has gone")
        view = view[count:]
    return data


def messages(path: str, *parts: str):
    """Yields (type, told, arrays): what the JSON tells, with sequence, time_ns and lost; parts by name as [v, u(, xyz)]."""
    with socket.socket(socket.AF_UNIX) as connection:
        connection.connect(path)
        connection.sendall(" ".join(("alltact-stream/1", *parts)).encode() + b"\n")
        while True:
            magic, version, kind, count, text, size, sequence, time_ns, lost = struct.unpack("<4sHHIIQQqQ", exactly(connection, 48))
            assert magic == b"ATCT" and version == 1, "this is no alltact serve"
            body, arrays = exactly(connection, size), {}
            for name, dtype, rows, columns, channels, offset, _ in struct.iter_unpack("<16s4sIIIQQ", body[:48 * count]):
                pixels = np.frombuffer(body, dtype.rstrip(b"\0").decode(), rows * columns * channels, offset)
                arrays[name.rstrip(b"\0").decode()] = pixels.reshape(rows, columns, *[channels] * (channels > 1))
            told = json.loads(body[48 * count:48 * count + text])
            yield TYPES[kind], {**told, "sequence": sequence, "time_ns": time_ns, "lost": lost}, arrays
            if kind > 3:
                return


if __name__ == "__main__":
    for kind, told, arrays in messages(sys.argv[1], *sys.argv[2:]):
        print(json.dumps({"type": kind, **told, "arrays": {name: array.shape for name, array in arrays.items()}}), flush=True)
