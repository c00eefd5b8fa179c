"""One line of JSON for each check, and nothing else on standard output."""
import json
import sys
import time

sys.dont_write_bytecode = True


def check(name, action, wanted):
    """Does something and compares what comes of it; `wanted` is a value, or a function that says whether a value is right."""
    try:
        got = action()
    except Exception as error:  # What a client throws is what it says.
        got = f"{type(error).__name__}: {error}"
    if isinstance(got, (bytes, bytearray)):
        got = got.hex()
    right = wanted(got) if callable(wanted) else got == wanted
    print(json.dumps({"check": name, "ok": bool(right), "got": got}, default=str), flush=True)
    return got


def again(action, wanted, seconds=5):
    """What an action gives as soon as it is what is wanted; a scan may lie between."""
    limit = time.monotonic() + seconds
    while True:
        got = action()
        if got == wanted or time.monotonic() > limit:
            return got
        time.sleep(0.02)


def refused(*words):
    """What is right is an error that says one of these words."""
    return lambda got: isinstance(got, str) and any(word.lower() in got.lower() for word in words)


def end():
    """Says that a script came to its end."""
    print(json.dumps({"check": "end", "ok": True, "got": None}), flush=True)
