'use strict';
// What @st-one-io/nodes7 can do, against a running CPU: `node st-one-nodes7.js PORT all`. It has no control and no password.
const { check, refused, end, again } = require('./shared/checks.js');
const { S7Endpoint, S7ItemGroup } = require('@st-one-io/nodes7');

const port = Number(process.argv[2]);
const plc = new S7Endpoint({ host: '127.0.0.1', port, rack: 0, slot: 2, autoReconnect: 0 });
plc.on('error', () => {});

async function read(...addresses) {
    const group = new S7ItemGroup(plc);
    group.setTranslationCB((tag) => tag);
    group.addItems(addresses);
    const values = await group.readAllItems();
    return addresses.map((address) => values[address]);
}

async function written(wanted) {
    const group = new S7ItemGroup(plc);
    group.setTranslationCB((tag) => tag);
    group.addItems(Object.keys(wanted));
    await group.writeItems(Object.keys(wanted), Object.values(wanted));
    return read(...Object.keys(wanted));
}

const VALUES = {
    'DB1,REAL0': 12.5, 'DB1,INT4': 1234, 'DB1,DINT6': 70000, 'DB1,X10.0': true, 'DB1,X10.1': false, 'DB1,WORD12': 0xABCD, 'DB1,DWORD14': 0x12345678,
    'DB1,S18.10': 'pump', 'DB1,BYTE31': 0x7F, 'M20.0': false, 'IB1': 0, 'QB4': 0, 'MW10': 0,
};
// The library leaves out the fill byte after a bit or a byte that others follow, which no CPU takes: those are written alone.
const NEW = { 'DB1,REAL0': -2.5, 'DB1,INT4': -7, 'DB1,DINT6': -70000, 'DB1,WORD12': 1, 'MI10': -1 };

(async () => {
    await check('connect', async () => { await plc.connect(); return plc.isConnected; }, true);
    await check('read all types', () => read(...Object.keys(VALUES)), Object.values(VALUES));
    await check('write all types', () => written(NEW), Object.values(NEW));
    await check('write bits', async () => [...await written({ 'DB1,X10.1': true }), ...await written({ 'M20.3': true })], [true, true]);
    await check('a bit changes no other bit', () => read('DB1,BYTE10', 'MB20'), [3, 8]);
    // Its `writeDB` sends empty pieces from the second one on.
    const data = Buffer.from(Array.from({ length: 200 }, (_, index) => index % 251));
    await check('write a large block', async () => { await plc.writeDB(1, 52, data); return (await plc.readDB(1, 52, 200)).equals(data); }, true);
    await check('read more than a PDU', async () => (await plc.readDB(1, 0, 652)).length, 652);
    await check('read inputs', () => plc.readInputs(1, 1), '00');
    await check('write outputs', async () => { await plc.writeOutputs(4, Buffer.from([0x5A])); return plc.readOutputs(4, 1); }, '5a');
    await check('write bit memory', async () => { await plc.writeFlags(30, Buffer.from([1, 2])); return plc.readFlags(30, 2); }, '0102');
    await check('a data block that is missing', () => plc.readDB(999, 0, 4), refused('not', 'exist', 'error'));
    await check('beyond the end', () => plc.readDB(1, 650, 10), refused('address', 'range', 'error'));
    await check('a data block that is READ_ONLY', () => plc.writeDB(2, 0, Buffer.from([0, 1])), refused('access', 'denied', 'error'));
    await check('the connection goes on', () => read('DB3,INT0', 'DB3,INT2'), [11, 22]);

    await check('read the clock', async () => (await plc.getTime()) instanceof Date, true);
    // The library writes milliseconds and weekday over the seconds; with none of them the moment is right.
    const moment = new Date(2024, 1, 29, 12, 34, 0, 0);
    await check('set the clock', async () => { await plc.setTime(moment); return Math.abs((await plc.getTime()) - moment) < 70000; }, true);
    await check('count blocks', async () => { const counts = await plc.blockCount(); return ['OB', 'DB', 'FC', 'FB'].map((type) => counts[type]); }, [1, 3, 1, 0]);
    await check('list data blocks', async () => (await plc.listBlocks('DB')).map((block) => block.number), [1, 2, 3]);
    await check('list blocks of a type without any', () => plc.listBlocks('FB'), refused('d20e', 'no further', 'error', 'block'));
    await check('information about a data block', async () => { const info = await plc.getBlockInfo('DB', 1); return info.length > 0 || Object.keys(info).length > 0; }, true);
    await check('information about a block that is missing', () => plc.getBlockInfo('FC', 77), refused('d209', 'not found', 'error', 'block'));
    await check('upload a data block', async () => { const block = await plc.uploadBlock('DB', 3); return block.slice(0, 2).toString('hex') + block.slice(36, 40).toString('hex'); }, '7070000b0016');
    await check('upload a function from a source', () => plc.uploadBlock('FC', 1), refused('d241', 'protect', 'error', 'permitted'));
    await check('all status lists', async () => (await plc.getAvailableSSL()).length > 30, true);
    await check('a status list', async () => (await plc.getSSL(0x0011)).length >= 3, true);
    await check('a status list that is missing', () => plc.getSSL(0x0F55, 0, true), refused('d401', 'szl', 'ssl', 'error'));
    await check('modules', async () => JSON.stringify(await plc.getModuleIdentification()).includes('6ES7 315-2EH14-0AB0'), true);
    await check('components', async () => JSON.stringify(await plc.getComponentIdentification()).includes('CPU 315-2 PN/DP'), true);
    await check('disconnect', async () => { await plc.disconnect(); return plc.isConnected; }, false);
    end();
})();
