'use strict';
// What nodes7 can do, against a running CPU: `node nodes7.js PORT all`. It has no clock, no blocks and no control.
const { check, end, again, same } = require('./shared/checks.js');
const NodeS7 = require('nodes7');

const port = Number(process.argv[2]);
const connection = new NodeS7({ silent: true });

const connect = (options) => new Promise((resolve, reject) =>
    connection.initiateConnection({ port, host: '127.0.0.1', timeout: 10000, debug: false, ...options }, (error) => (error ? reject(error) : resolve('connected'))));
const drop = () => new Promise((resolve) => connection.dropConnection(resolve));

/** Reads addresses; what is bad is told by the text that the library gives instead of a value. */
async function read(...addresses) {
    connection.removeItems();
    connection.addItems(addresses);
    return new Promise((resolve) => connection.readAllItems((bad, values) => resolve(addresses.map((address) => values[address]))));
}

const write = (addresses, values) => new Promise((resolve, reject) => {
    if (connection.writeItems(addresses, values, (bad) => (bad ? reject(new Error('a value is bad')) : resolve())) !== 0) reject(new Error('busy'));
});

const VALUES = {
    'DB1,REAL0': 12.5, 'DB1,INT4': 1234, 'DB1,DINT6': 70000, 'DB1,X10.0': true, 'DB1,X10.1': false, 'DB1,WORD12': 0xABCD, 'DB1,DWORD14': 0x12345678,
    'DB1,S18.10': 'pump', 'DB1,CHAR30': 'x', 'DB1,BYTE31': 0x7F, 'DB1,BYTE52.4': [0, 0, 0, 0], 'M20.0': false, 'IB1': 0, 'QB4': 0, 'MW10': 0, 'T2': 0, 'C2': 0,
};
const NEW = {
    'DB1,REAL0': -2.5, 'DB1,INT4': -7, 'DB1,DINT6': -70000, 'DB1,X10.1': true, 'DB1,WORD12': 1, 'DB1,S18.10': 'valve', 'DB1,CHAR30': 'y', 'DB1,BYTE52.4': [1, 2, 3, 4],
    'M20.3': true, 'QB4': 0xA5, 'MI10': -1, 'MR24': 0.5,
};

(async () => {
    await check('connect', () => connect({ rack: 0, slot: 2 }), 'connected');
    await check('read all types', () => read(...Object.keys(VALUES)), Object.values(VALUES));
    await check('date and time', async () => (await read('DB1,DT32'))[0].getFullYear(), 2024);
    await check('write all types', async () => { await write(Object.keys(NEW), Object.values(NEW)); return read(...Object.keys(NEW)); }, Object.values(NEW));
    await check('a bit changes no other bit', () => read('DB1,BYTE10', 'MB20'), [3, 8]);
    const numbers = Array.from({ length: 250 }, (_, index) => index - 125);
    await check('write more than a PDU', async () => { await write('DB1,INT60.250', numbers); return (await read('DB1,INT60.250'))[0]; }, numbers);
    const scattered = Array.from({ length: 60 }, (_, index) => `DB1,X${100 + 7 * index}.${index % 8}`);
    await check('more than one request holds', async () => (await read(...scattered)).every((value) => typeof value === 'boolean'), true);
    await check('the program answers', async () => { await write('I0.0', true); return again(() => read('Q0.0'), (got) => got[0] === true); }, [true]);
    await check('one of several is missing', () => read('DB3,INT0', 'DB999,INT0', 'DB3,INT2'), (got) => got[0] === 11 && got[2] === 22 && /^BAD/.test(got[1]));
    await check('beyond the end', () => read('DB3,INT0', 'DB1,INT651', 'MB10'), (got) => got[0] === 11 && /^BAD/.test(got[1]) && got[2] === 255);
    await check('a data block that is READ_ONLY', () => write(['DB2,INT0'], [1]), 'Error: a value is bad');
    await check('the connection goes on', () => read('DB3,INT0'), [11]);
    await drop();
    await check('connect by TSAP', () => connect({ localTSAP: 0x0100, remoteTSAP: 0x0302 }), 'connected');
    await check('read again', () => read('DB3,INT0'), [11]);
    await drop();
    end();
})();
