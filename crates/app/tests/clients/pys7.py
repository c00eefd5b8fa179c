"""What pyS7 can do, against a running CPU: `python pys7.py PORT all`. It has no clock, no blocks and no control."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "shared"))
from checks import check, end, refused
from pyS7 import S7Client

PORT = int(sys.argv[1])
client = S7Client("127.0.0.1", 0, 2, port=PORT)
check("connect", lambda: (client.connect(), client.pdu_size)[1], 240)

VALUES = {"DB1,R0": 12.5, "DB1,I4": 1234, "DB1,DI6": 70000, "DB1,X10.0": True, "DB1,X10.1": False, "DB1,W12": 0xABCD, "DB1,DW14": 0x12345678,
          "DB1,S18.10": "pump", "DB1,C30": "x", "DB1,B31": 0x7F, "M20.0": False, "IB1": 0, "QB4": 0, "MW10": 0}
check("read all types in one call", lambda: client.read(list(VALUES)), list(VALUES.values()))
check("read them one by one", lambda: client.read(list(VALUES), optimize=False), list(VALUES.values()))
check("read more than one request holds", lambda: client.read([f"DB1,B{52 + 2 * number}" for number in range(60)], optimize=False), [0] * 60)


def written(addresses, values):
    client.write(addresses, values)
    return client.read(addresses)


NEW = {"DB1,R0": -2.5, "DB1,I4": -7, "DB1,DI6": -70000, "DB1,X10.1": True, "DB1,W12": 1, "DB1,S18.10": "valve", "DB1,C30": "y", "M20.3": True, "QB4": 0xA5, "MI10": -1}
check("write all types in one call", lambda: written(list(NEW), list(NEW.values())), list(NEW.values()))
check("a bit changes no other bit", lambda: client.read(["DB1,B10", "MB20"]), [3, 8])
# Without `optimize` this client loses its place in the answer after an error.
check("one of several is missing", lambda: [
    (result.success, result.value) for result in client.read_detailed(["DB3,I0", "DB999,I0", "DB3,I2"])], [(True, 11), (False, None), (True, 22)])
check("a data block that is missing", lambda: client.read(["DB999,I0"]), refused("exist", "0x0a", "not"))
check("beyond the end", lambda: client.read(["DB1,I651"]), refused("out_of_range"))
check("a data block that is READ_ONLY", lambda: client.write(["DB2,I0"], [1]), refused("access", "denied", "0x03"))
check("the connection goes on", lambda: client.read(["DB3,I0"]), [11])
check("order code", lambda: client.get_cpu_info()["module_type_name"].strip(), "6ES7 315-2EH14-0AB0")
check("mode", lambda: str(client.get_cpu_status()), lambda got: "run" in got.lower())
client.disconnect()
end()
