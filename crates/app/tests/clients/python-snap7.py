"""What python-snap7 3 can do, against a running CPU: `python python-snap7.py PORT all|protected|tags`."""
import os
import struct
import sys
import time
from datetime import datetime, timedelta

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "shared"))
from checks import again, check, end, refused
from snap7 import Area, Block, Client, WordLen

PORT = int(sys.argv[1])


def connected(rack=0, slot=2):
    client = Client()
    client.connect("127.0.0.1", rack, slot, PORT)
    return client


def areas(client):
    check("read a REAL", lambda: client.read_area(Area.DB, 1, 0, 4), "41480000")
    check("read all types", lambda: client.db_read(1, 0, 52), "4148000004d2000111700100abcd123456780a0470756d70000000000000787f"
          "2402291234567895" "30bd" "0038d088" "000005dc" "0200")
    typed = [
        ("a BOOL", lambda: client.db_read_bool(1, 10, 0), True),
        ("an INT", lambda: client.db_read_int(1, 4), 1234),
        ("a DINT", lambda: client.db_read_dint(1, 6), 70000),
        ("a WORD", lambda: client.db_read_word(1, 12), 0xABCD),
        ("a DWORD", lambda: client.db_read_dword(1, 14), 0x12345678),
        ("a STRING", lambda: client.db_read_string(1, 18), "pump"),
        ("a BYTE", lambda: client.db_read_byte(1, 31), 0x7F),
        ("numbers in a row", lambda: client.db_read_array(3, 0, 2, ">h"), [11, 22]),
    ]
    for name, action, wanted in typed:
        check(f"read {name}", action, wanted)

    def written(write, read):
        return lambda: (write(), read())[1]

    check("write a REAL", written(lambda: client.db_write_real(1, 0, -2.5), lambda: client.db_read_real(1, 0)), -2.5)
    check("write a BOOL", written(lambda: client.db_write_bool(1, 10, 1, True), lambda: client.db_read(1, 10, 1)), "03")
    check("write a STRING", written(lambda: client.db_write_string(1, 18, "valve", 10), lambda: client.db_read_string(1, 18)), "valve")
    check("write a bit by itself", written(
        lambda: client.write_area(Area.MK, 0, 20 * 8 + 3, bytearray([1]), WordLen.Bit), lambda: client.mb_read(20, 1)), "08")
    check("write bit memory", written(lambda: client.mb_write(10, 4, bytearray([1, 2, 3, 4])), lambda: client.mb_read(10, 4)), "01020304")
    check("write outputs", written(lambda: client.ab_write(4, bytearray([0xA5])), lambda: client.ab_read(4, 1)), "a5")
    check("write inputs", lambda: (client.eb_write(0, 1, bytearray([0x12])), again(lambda: client.eb_read(0, 1), bytearray([0x12])))[1], "12")
    check("the program answers", lambda: (client.eb_write(0, 1, bytearray([1])), again(lambda: client.ab_read(0, 1)[0] & 1, 1))[1], 1)
    check("words in an area", lambda: client.read_area(Area.MK, 0, 10, 2, WordLen.Word), "01020304")
    check("a counter", lambda: (client.ct_write(2, 1, bytearray([0x00, 0x25])), client.ct_read(2, 1))[1], "0025")
    check("a counter that the program sets", lambda: (
        client.write_area(Area.MK, 0, 100 * 8 + 1, bytearray([1]), WordLen.Bit), again(lambda: client.ct_read(1, 1), bytearray([0, 0x25])))[1], "0025")
    check("a timer that the program starts", lambda: (
        client.write_area(Area.MK, 0, 100 * 8, bytearray([1]), WordLen.Bit), time.sleep(0.1), client.tm_read(1, 1))[2],
        lambda got: len(got) == 4 and got not in ("0000",))


def many(client):
    def items(*parts):
        return [{"area": area, "db_number": db, "start": start, "size": size} for area, db, start, size in parts]

    def read(parts):
        return lambda: [bytes(part).hex() for part in client.read_multi_vars(items(*parts))[1]]

    several = [(Area.DB, 3, 0, 2), (Area.DB, 3, 2, 2), (Area.MK, 0, 10, 4), (Area.PA, 0, 4, 1)]
    check("read several", read(several), ["000b", "0016", "01020304", "a5"])
    client.use_optimizer = False
    check("read several one by one", read(several), ["000b", "0016", "01020304", "a5"])
    check("read 18 in one request", read([(Area.DB, 1, 52 + 2 * number, 2) for number in range(18)]), ["0000"] * 18)
    check("read several with one that is missing", read([(Area.DB, 3, 0, 2), (Area.DB, 999, 0, 2), (Area.DB, 3, 2, 2)]), refused("exist", "0x0a", "item"))
    check("write several", lambda: (client.write_multi_vars([
        {"area": Area.DB, "db_number": 1, "start": 60, "data": bytearray([9, 8])},
        {"area": Area.MK, "db_number": 0, "start": 30, "data": bytearray([7])}]),
        [client.db_read(1, 60, 2).hex(), client.mb_read(30, 1).hex()])[1], ["0908", "07"])
    block = bytearray(number % 251 for number in range(600))
    check("write more than a PDU", lambda: (client.db_write(1, 52, block), client.db_read(1, 52, 600) == block)[1], True)
    check("a data block by itself", lambda: len(client.db_get(3)), 8)
    check("fill a data block", lambda: (client.db_fill(3, 0x11), client.db_read(3, 0, 8))[1], "11" * 8)


def errors(client):
    check("a data block that is missing", lambda: client.db_read(999, 0, 4), refused("exist", "0x0a"))
    check("beyond the end", lambda: client.db_read(1, 650, 10), refused("address", "0x05"))
    check("a data block that is READ_ONLY", lambda: client.db_write(2, 0, bytearray(2)), refused("access", "0x03"))
    check("the connection goes on", lambda: client.db_read_int(1, 4), 1234)


def identity(client):
    def words(number, index, count):
        return list(struct.unpack(f">{count}H", bytes(client.read_szl(number, index).Data[:2 * count])))

    info = lambda: {key: getattr(client.get_cpu_info(), key).decode() for key in ("ModuleTypeName", "ASName", "ModuleName")}
    check("CPU information", info, lambda got: got["ModuleTypeName"] == "CPU 315-2 PN/DP" and got["ASName"] != "")
    code = lambda: client.get_order_code()
    check("order code", lambda: code().OrderCode.decode().strip(), lambda got: got.startswith("6ES7 315-2EH14"))
    check("firmware", lambda: (code().V1, code().V2, code().V3), lambda got: got[0] == 3)
    check("state", client.get_cpu_state, "S7CpuStatusRun")
    # The data of a list begins with the length of its records here, so that this client's own readers of 0131 and 0232 are two words off.
    check("protection", lambda: words(0x0232, 4, 4), [40, 1, 4, 1])
    check("communication", lambda: words(0x0131, 1, 5), [40, 1, 1, 240, 16])
    check("list of status lists", lambda: len(client.read_szl_list()) > 50, True)
    check("a status list", lambda: words(0x0011, 0, 2), lambda got: got[0] == 28 and got[1] >= 3)
    check("a status list that is missing", lambda: client.read_szl(0x0F55), refused("d401", "0x8104", "szl", "error"))
    check("diagnostic buffer", lambda: len(client.read_diagnostic_buffer()) > 0, True)


def clock(client):
    moment = datetime(2024, 2, 29, 12, 34, 56)
    check("set the clock", lambda: (client.set_plc_datetime(moment), abs(client.get_plc_datetime() - moment) < timedelta(seconds=30))[1], True)
    check("set the clock to that of the computer", lambda: (
        client.set_plc_system_datetime(), abs(client.get_plc_datetime() - datetime.now()) < timedelta(seconds=30))[1], True)


def blocks(client):
    counts = lambda: {kind: getattr(client.list_blocks(), f"{kind}Count") for kind in ("OB", "FC", "FB", "DB")}
    check("count blocks", counts, {"OB": 1, "FC": 1, "FB": 0, "DB": 3})
    check("list data blocks", lambda: client.list_blocks_of_type(Block.DB, 100), [1, 2, 3])
    check("list functions", lambda: client.list_blocks_of_type(Block.FC, 100), [1])
    check("list system functions", lambda: len(client.list_blocks_of_type(Block.SFC, 200)) > 20, True)
    about = lambda kind, number: (lambda info: (info.BlkNumber, info.BlkLang, info.MC7Size))(client.get_block_info(kind, number))
    check("information about a data block", lambda: about(Block.DB, 1), (1, 5, 652))
    check("information about a function", lambda: about(Block.FC, 1), (1, 1, 0))
    check("information about a block that is missing", lambda: about(Block.FC, 77), refused("d209", "not found", "error"))
    image = {}

    def upload():
        data, size = client.full_upload(Block.DB, 3)
        image["DB 3"] = bytes(data[:size])
        return (image["DB 3"][:2].hex(), int.from_bytes(image["DB 3"][8:12], "big") == size, image["DB 3"][36:44].hex())

    check("upload a data block", upload, ("7070", True, "11" * 8))
    check("upload its values", lambda: client.upload(3), lambda got: "11" * 8 in got)
    check("upload a function from a source", lambda: client.full_upload(Block.FC, 1), refused("protect", "d241", "error"))
    # This client sends no request to link: what it downloads stays stored and not linked.
    check("download a data block", lambda: client.download(bytearray(image["DB 3"])), 0)
    check("what was downloaded changes no value", lambda: client.db_read(3, 0, 2), "1111")
    check("delete with another syntax than a CPU has", lambda: client.delete(Block.DB, 3), lambda got: got == 0 or isinstance(got, str))


def control(client):
    check("copy RAM to ROM", lambda: client.copy_ram_to_rom(1000), 0)
    check("compress", lambda: client.compress(1000), 0)
    mode = lambda: client.read_szl(0x0424).Data[7] & 0x0F
    check("stop", lambda: (client.plc_stop(), mode())[1], 4)
    scans = lambda: client.mb_read(200, 2)
    check("no scan in STOP", lambda: (lambda before: (time.sleep(0.1), scans() == before)[1])(scans()), True)
    check("write in STOP", lambda: (client.db_write_int(1, 4, 5), client.db_read_int(1, 4))[1], 5)
    check("warm start", lambda: (client.plc_hot_start(), again(mode, 8))[1], 8)
    check("start in RUN", client.plc_hot_start, refused("already", "0x03", "error", "fail"))
    check("stop for a cold start", lambda: (client.plc_stop(), mode())[1], 4)
    check("cold start", lambda: (client.plc_cold_start(), again(mode, 8))[1], 8)
    check("initial values after a cold start", lambda: client.db_read_int(1, 4), 1234)


def protected():
    client = connected()
    check("read variables", lambda: client.db_read_int(1, 4), 1234)
    check("stop without the password", client.plc_stop, refused("protect", "d241", "error", "password"))
    check("upload without the password", lambda: client.full_upload(Block.DB, 3), refused("protect", "d241", "error", "password"))
    check("a wrong password", lambda: client.set_session_password("wrong"), refused("d602", "password", "error"))
    check("still no stop", client.plc_stop, refused("protect", "d241", "error", "password"))
    check("the password", lambda: client.set_session_password("secret"), 0)
    check("upload with the password", lambda: client.full_upload(Block.DB, 3)[0][:2], "7070")
    check("stop with the password", client.plc_stop, 0)
    check("give the password back", client.clear_session_password, 0)
    check("start without the password", client.plc_hot_start, refused("protect", "d241", "error", "password"))
    other = connected()
    check("the password is of its connection", other.plc_hot_start, refused("protect", "d241", "error", "password"))


def everything():
    client = connected()
    check("connect", lambda: (client.get_connected(), client.pdu_length), (True, 240))
    check("connect to another slot", lambda: connected(1, 1).db_read_int(1, 4), 1234)
    for part in (areas, many, errors, identity, clock, blocks, control):
        part(client)
    client.disconnect()


{"all": everything, "protected": protected}[sys.argv[2]]()
end()
