"""The native Snap7 server with bit memory and DB 1, for the measurement beside ours: native_server.py PORT"""

import ctypes
import sys
import time

from snap7.server import Server
from snap7.types import srvAreaDB, srvAreaMK

server = Server(log=False)
server.register_area(srvAreaMK, 0, (ctypes.c_uint8 * 2048)())
server.register_area(srvAreaDB, 1, (ctypes.c_uint8 * 4000)())
server.start(tcpport=int(sys.argv[1]))
print("ready", flush=True)
while True:
    time.sleep(3600)
