"""What the native Snap7 can do, by its wrapper python-snap7 1.3, against a running CPU: `python native-snap7.py PORT all|protected`."""
import ctypes
import os
import sys
import time
from ctypes import POINTER, c_int32, c_uint8, cast, pointer
from datetime import datetime, timedelta

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "shared"))
from checks import again, check, end, refused
import snap7
from snap7.types import Areas, S7DataItem, S7WLBit, S7WLByte, S7WLCounter, S7WLWord

PORT = int(sys.argv[1])
# What the library gives for an error, where the wrapper throws none.
CANNOT_START, ALREADY_RUN, CANNOT_STOP, ALREADY_STOP, DELETE_REFUSED = 0x00E00000, 0x00F00000, 0x01000000, 0x01300000, 0x01C00000


def done(got):
    """Some functions of the wrapper give 0, and some nothing."""
    return got in (0, None)


def connected(rack=0, slot=2):
    client = snap7.client.Client()
    client.connect("127.0.0.1", rack, slot, PORT)
    return client


def items(parts):
    """A list of variables with room for their values."""
    array = (S7DataItem * len(parts))()
    rooms = []
    for item, (area, length, db, start, amount, data) in zip(array, parts):
        room = ctypes.create_string_buffer(data or b"", max(len(data or b""), amount * {S7WLBit: 1, S7WLByte: 1}.get(length, 2)))
        rooms.append(room)
        item.Area, item.WordLen, item.DBNumber, item.Start, item.Amount = c_int32(area.value), c_int32(length), c_int32(db), c_int32(start), c_int32(amount)
        item.pData = cast(pointer(room), POINTER(c_uint8))
    return array, rooms


def areas(client):
    check("read all types", lambda: client.db_read(1, 0, 52), "4148000004d2000111700100abcd123456780a0470756d70000000000000787f"
          "2402291234567895" "30bd" "0038d088" "000005dc" "0200")

    def written(write, read):
        return lambda: (write(), read())[1]

    check("write a REAL", written(lambda: client.db_write(1, 0, bytearray(b"\xc0\x20\0\0")), lambda: client.db_read(1, 0, 4)), "c0200000")
    check("write bit memory", written(lambda: client.mb_write(10, 4, bytearray([1, 2, 3, 4])), lambda: client.mb_read(10, 4)), "01020304")
    check("write outputs", written(lambda: client.ab_write(4, bytearray([0xA5])), lambda: client.ab_read(4, 1)), "a5")
    check("write inputs", lambda: (client.eb_write(0, 1, bytearray([0x12])), again(lambda: client.eb_read(0, 1), bytearray([0x12])))[1], "12")
    check("the program answers", lambda: (client.eb_write(0, 1, bytearray([1])), again(lambda: client.ab_read(0, 1)[0] & 1, 1))[1], 1)
    check("a counter", written(lambda: client.ct_write(2, 1, bytearray([0x00, 0x25])), lambda: client.ct_read(2, 1)), "0025")
    check("a timer", lambda: client.tm_read(2, 1), "0000")
    bit, _ = items([(Areas.MK, S7WLBit, 0, 20 * 8 + 3, 1, b"\1")])
    check("write a bit by itself", written(lambda: client.write_multi_vars([bit[0]]), lambda: client.mb_read(20, 1)), "08")


def many(client):
    def read(parts):
        array, rooms = items(parts)
        result, _ = client.read_multi_vars(array)
        return result, [(item.Result, room.raw.hex() if item.Result == 0 else "") for item, room in zip(array, rooms)]

    several = [(Areas.DB, S7WLByte, 3, 0, 4, None), (Areas.MK, S7WLWord, 0, 10, 2, None), (Areas.CT, S7WLCounter, 0, 2, 1, None), (Areas.MK, S7WLBit, 0, 163, 1, None)]
    check("read several", lambda: read(several), lambda got: got == (0, [(0, "000b0016"), (0, "01020304"), (0, "0025"), (0, "01")]))
    check("read 18 in one request", lambda: [text for _, text in read([(Areas.DB, S7WLByte, 1, 52 + 2 * number, 2, None) for number in range(18)])[1]], ["0000"] * 18)
    wrong = [(Areas.DB, S7WLByte, 3, 0, 1, None), (Areas.DB, S7WLByte, 999, 0, 2, None), (Areas.DB, S7WLByte, 1, 700, 2, None), (Areas.DB, S7WLByte, 3, 3, 1, None)]
    check("read several with two that are missing", lambda: read(wrong)[1], lambda got: [room for _, room in got] == ["00", "", "", "16"] and got[1][0] != 0 and got[1][0] != got[2][0])

    def write():
        array, _ = items([(Areas.DB, S7WLByte, 1, 60, 2, b"\x09\x08"), (Areas.DB, S7WLByte, 999, 0, 1, b"\0"), (Areas.MK, S7WLByte, 0, 30, 1, b"\x07")])
        client.write_multi_vars(list(array))
        return client.db_read(1, 60, 2).hex(), client.mb_read(30, 1).hex()

    check("write several with one that is missing", write, lambda got: got == ("0908", "07"))
    block = bytearray(number % 251 for number in range(600))
    check("write more than a PDU", lambda: (client.db_write(1, 52, block), client.db_read(1, 52, 600) == block)[1], True)
    check("a data block by itself", lambda: client.db_get(3)[:8], "000b001640600000")
    check("fill a data block", lambda: (client.db_fill(3, 0x11), client.db_read(3, 0, 8))[1], "11" * 8)


def errors(client):
    check("a data block that is missing", lambda: client.db_read(999, 0, 4), refused("not available", "not found"))
    check("beyond the end", lambda: client.db_read(1, 650, 10), refused("address out of range"))
    check("a data block that is READ_ONLY", lambda: client.db_write(2, 0, bytearray(2)), refused("not available", "access", "CPU"))
    check("the connection goes on", lambda: client.db_read(1, 4, 2), "04d2")


def identity(client):
    info = lambda: client.get_cpu_info()
    check("name of the CPU", lambda: info().ModuleTypeName.decode(), "CPU 315-2 PN/DP")
    check("name of the plant", lambda: info().ASName.decode(), lambda got: got != "")
    code = lambda: client.get_order_code()
    check("order code", lambda: code().OrderCode.decode().strip(), "6ES7 315-2EH14-0AB0")
    check("firmware", lambda: [code().V1, code().V2, code().V3], [3, 2, 6])
    check("state", client.get_cpu_state, "S7CpuStatusRun")
    check("protection", lambda: [getattr(client.get_protection(), name) for name in ("sch_schal", "sch_par", "sch_rel")], lambda got: got == [1, 0, 1])
    check("communication", lambda: client.get_cp_info().MaxPduLength, 240)
    check("list of status lists", lambda: client.read_szl_list(), lambda got: "00110012" in got)
    check("a status list", lambda: client.read_szl(0x0011).Header.LengthDR, 28)
    check("a status list that is missing", lambda: client.read_szl(0x0F55), refused("not available", "error", "CPU"))
    check("length of the PDU", client.get_pdu_length, 240)


def clock(client):
    moment = datetime(2024, 2, 29, 12, 34, 56)
    check("set the clock", lambda: (client.set_plc_datetime(moment), abs(client.get_plc_datetime() - moment) < timedelta(seconds=30))[1], True)
    check("set the clock to that of the computer", lambda: (
        client.set_plc_system_datetime(), abs(client.get_plc_datetime() - datetime.now()) < timedelta(seconds=30))[1], True)


def blocks(client):
    # The wrapper gives as many numbers as were asked for; what is no block is 0, as SFC 0 is.
    def listed(kind):
        return [number for number in client.list_blocks_of_type(kind, 1000) if number != 0]

    counts = lambda: {kind: getattr(client.list_blocks(), f"{kind}Count") for kind in ("OB", "FC", "FB", "DB")}
    check("count blocks", counts, {"OB": 1, "FC": 1, "FB": 0, "DB": 3})
    check("list data blocks", lambda: listed("DB"), [1, 2, 3])
    check("list system functions", lambda: len(listed("SFC")) > 20, True)
    about = lambda kind, number: (lambda info: [info.BlkNumber, info.BlkLang, info.MC7Size])(client.get_block_info(kind, number))
    check("information about a data block", lambda: about("DB", 1), [1, 5, 652])
    check("information about a function", lambda: about("FC", 1), [1, 1, 0])
    check("information about a block that is missing", lambda: about("FC", 77), refused("not available", "not found", "CPU"))
    image = {}

    def upload():
        data, size = client.full_upload("DB", 3)
        image["DB 3"] = bytearray(data[:size])
        return [image["DB 3"][:2].hex(), int.from_bytes(image["DB 3"][8:12], "big") == size, image["DB 3"][36:44].hex()]

    check("upload a data block", upload, ["7070", True, "11" * 8])
    check("upload its values", lambda: client.upload(3)[:8], "11" * 8)
    check("upload a function from a source", lambda: client.full_upload("FC", 1), refused("protect", "not permitted", "level", "CPU", "not authorized", "needed"))

    def download(number):
        block = bytearray(image["DB 3"])
        block[36:44] = bytes.fromhex("0022003340600000")
        return client.download(block, number)

    check("download a data block with other values", lambda: (download(3), client.db_read(3, 0, 8))[1], "0022003340600000")
    check("download a new data block", lambda: (download(30), client.db_read(30, 0, 8))[1], "0022003340600000")
    check("it is listed", lambda: listed("DB"), [1, 2, 3, 30])
    check("delete it", lambda: (client.delete("DB", 30), listed("DB"))[1], [1, 2, 3])
    check("delete a block that is missing", lambda: client.delete("DB", 30), DELETE_REFUSED)
    check("the program runs on", lambda: (lambda before: (time.sleep(0.1), client.mb_read(200, 2) != before)[1])(client.mb_read(200, 2)), True)


def control(client):
    check("copy RAM to ROM", lambda: client.copy_ram_to_rom(3000), 0)
    check("compress", lambda: client.compress(3000), done)
    check("stop", lambda: (client.plc_stop(), client.get_cpu_state())[1], "S7CpuStatusStop")
    scans = lambda: client.mb_read(200, 2)
    check("no scan in STOP", lambda: (lambda before: (time.sleep(0.1), scans() == before)[1])(scans()), True)
    check("stop in STOP", client.plc_stop, ALREADY_STOP)
    check("write in STOP", lambda: (client.db_write(1, 4, bytearray([0, 5])), client.db_read(1, 4, 2))[1], "0005")
    check("warm start", lambda: (client.plc_hot_start(), again(client.get_cpu_state, "S7CpuStatusRun"))[1], "S7CpuStatusRun")
    check("start in RUN", client.plc_hot_start, ALREADY_RUN)
    check("cold start", lambda: (client.plc_stop(), client.plc_cold_start(), again(client.get_cpu_state, "S7CpuStatusRun"))[2], "S7CpuStatusRun")
    check("initial values after a cold start", lambda: client.db_read(1, 4, 2), "04d2")


def protected():
    client = connected()
    level = ("protect", "level", "authorized", "password", "needed", "not permitted", "CPU")
    check("read variables", lambda: client.db_read(1, 4, 2), "04d2")
    check("the level is shown", lambda: [getattr(client.get_protection(), name) for name in ("sch_schal", "sch_par", "sch_rel")], lambda got: got == [1, 3, 3])
    check("stop without the password", client.plc_stop, CANNOT_STOP)
    check("still in RUN", client.get_cpu_state, "S7CpuStatusRun")
    check("upload without the password", lambda: client.full_upload("DB", 3), refused(*level))
    check("a wrong password", lambda: client.set_session_password("wrong"), refused("password"))
    check("the password", lambda: client.set_session_password("secret"), done)
    check("upload with the password", lambda: client.full_upload("DB", 3)[0][:2], "7070")
    check("stop with the password", lambda: (client.plc_stop(), client.get_cpu_state())[1], "S7CpuStatusStop")
    check("give the password back", client.clear_session_password, done)
    check("start without the password", client.plc_hot_start, CANNOT_START)


def everything():
    client = connected()
    check("connect", client.get_connected, True)
    check("connect to another slot", lambda: connected(1, 1).db_read(1, 4, 2), "04d2")
    for part in (areas, many, errors, identity, clock, blocks, control):
        part(client)
    client.disconnect()


{"all": everything, "protected": protected}[sys.argv[2]]()
end()
