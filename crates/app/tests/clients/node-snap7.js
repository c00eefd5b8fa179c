'use strict';
// What node-snap7 can do, against a running CPU: `node node-snap7.js PORT all|protected`.
const { check, refused, end, pause, again } = require('./shared/checks.js');
const snap7 = require('node-snap7');

const port = Number(process.argv[2]);
const client = new snap7.S7Client();

/** Calls a function of the client without blocking; an error has the text of the library. */
const call = (name, ...parts) => new Promise((resolve, reject) =>
    client[name](...parts, (error, result) => (error ? reject(new Error(client.ErrorText(error))) : resolve(result))));

const connect = async () => {
    client.SetParam(client.RemotePort, port);
    await call('ConnectTo', '127.0.0.1', 0, 2);
    return client.PDULength();
};
const { S7AreaDB, S7AreaMK, S7AreaCT, S7AreaPA } = client;
const { S7WLByte, S7WLBit, S7WLWord, S7WLCounter } = client;
const LEVEL = ['cannot', 'level', 'authorized', 'protect', 'password', 'refused'];

async function areas() {
    await check('read all types', () => call('DBRead', 1, 0, 18), '4148000004d2000111700100abcd12345678');
    const round = (write, read) => async () => { await write(); return read(); };
    await check('write a data block', round(() => call('DBWrite', 1, 4, 2, Buffer.from([0xFF, 0xF9])), () => call('DBRead', 1, 4, 2)), 'fff9');
    await check('write bit memory', round(() => call('MBWrite', 10, 2, Buffer.from([1, 2])), () => call('MBRead', 10, 2)), '0102');
    await check('write outputs', round(() => call('ABWrite', 4, 1, Buffer.from([0xA5])), () => call('ABRead', 4, 1)), 'a5');
    await check('the program answers', round(() => call('EBWrite', 0, 1, Buffer.from([1])), () => again(() => call('ABRead', 0, 1), (got) => (got[0] & 1) === 1)), '01');
    await check('a counter', round(() => call('CTWrite', 2, 1, Buffer.from([0, 0x25])), () => call('CTRead', 2, 1)), '0025');
    await check('a timer', () => call('TMRead', 2, 1), '0000');
    await check('write a bit by itself', round(() => call('WriteArea', S7AreaMK, 0, 163, 1, S7WLBit, Buffer.from([1])), () => call('MBRead', 20, 1)), '08');
    await check('words in an area', () => call('ReadArea', S7AreaMK, 0, 10, 1, S7WLWord), '0102');
    const data = Buffer.from(Array.from({ length: 600 }, (_, index) => index % 251));
    await check('write more than a PDU', async () => { await call('DBWrite', 1, 52, 600, data); return (await call('DBRead', 1, 52, 600)).equals(data); }, true);
}

async function many() {
    const item = (Area, WordLen, DBNumber, Start, Amount, Data) => ({ Area, WordLen, DBNumber, Start, Amount, ...(Data ? { Data: Buffer.from(Data) } : {}) });
    const read = async (...items) => (await call('ReadMultiVars', items)).map((result) => (result.Result === 0 ? result.Data.toString('hex') : client.ErrorText(result.Result)));
    await check('read several', () => read(item(S7AreaDB, S7WLByte, 3, 0, 4), item(S7AreaMK, S7WLWord, 0, 10, 1), item(S7AreaCT, S7WLCounter, 0, 2, 1), item(S7AreaPA, S7WLByte, 0, 4, 1)),
        ['000b0016', '0102', '0025', 'a5']);
    await check('read several with one that is missing', () => read(item(S7AreaDB, S7WLByte, 3, 0, 1), item(S7AreaDB, S7WLByte, 999, 0, 2), item(S7AreaDB, S7WLByte, 3, 3, 1)),
        (got) => got[0] === '00' && got[2] === '16' && /not available/i.test(got[1]));
    await check('write several with one that is missing', async () => (await call('WriteMultiVars', [
        item(S7AreaDB, S7WLByte, 1, 60, 1, [9]), item(S7AreaDB, S7WLByte, 999, 0, 1, [0]), item(S7AreaMK, S7WLByte, 0, 30, 1, [7])])).map((result) => result.Result === 0), [true, false, true]);
    await check('a data block that is missing', () => call('DBRead', 999, 0, 4), refused('not available'));
    await check('beyond the end', () => call('DBRead', 1, 650, 10), refused('address out of range'));
    await check('a data block that is READ_ONLY', () => call('DBWrite', 2, 0, 1, Buffer.from([1])), refused('cpu', 'access', 'not'));
    await check('the connection goes on', () => call('DBRead', 3, 0, 2), '000b');
}

async function identity() {
    await check('name of the CPU', async () => (await call('GetCpuInfo')).ModuleTypeName, 'CPU 315-2 PN/DP');
    await check('order code', async () => { const code = await call('GetOrderCode'); return [code.Code.trim(), code.V1, code.V2, code.V3]; }, ['6ES7 315-2EH14-0AB0', 3, 2, 6]);
    await check('communication', async () => (await call('GetCpInfo')).MaxPduLength, 240);
    await check('protection', async () => { const level = await call('GetProtection'); return [level.sch_schal, level.sch_par, level.sch_rel]; }, [1, 0, 1]);
    await check('mode', () => call('PlcStatus'), client.S7CpuStatusRun);
    await check('a status list', async () => (await call('ReadSZL', 0x0011, 0)).length > 80, true);
    await check('list of status lists', async () => (await call('ReadSZLList')).length > 50, true);
    await check('count blocks', async () => { const counts = await call('ListBlocks'); return [counts.OBCount, counts.DBCount, counts.FCCount]; }, [1, 3, 1]);
    await check('list data blocks', () => call('ListBlocksOfType', client.Block_DB), [1, 2, 3]);
    await check('information about a data block', async () => { const info = await call('GetAgBlockInfo', client.Block_DB, 1); return [info.BlkNumber, info.MC7Size]; }, [1, 652]);
    const moment = new Date(2024, 1, 29, 12, 34, 56);
    await check('set the clock', async () => { await call('SetPlcDateTime', moment); return Math.abs((await call('GetPlcDateTime')) - moment) < 30000; }, true);
}

async function blocks() {
    let image;
    await check('upload a data block', async () => { image = await call('FullUpload', client.Block_DB, 3, 1024); return image.subarray(0, 2).toString('hex') + image.subarray(36, 40).toString('hex'); }, '7070000b0016');
    await check('upload a function from a source', () => call('FullUpload', client.Block_FC, 1, 1024), refused(...LEVEL));
    await check('a data block by itself', async () => (await call('DBGet', 3)).subarray(0, 4), '000b0016');
    await check('fill a data block', async () => { await call('DBFill', 3, 0x11); return call('DBRead', 3, 0, 8); }, '1111111111111111');
    await check('download a data block with other values', async () => { await call('Download', 3, image); return call('DBRead', 3, 0, 4); }, '000b0016');
}

async function control() {
    await check('copy RAM to ROM', async () => { await call('CopyRamToRom', 3000); return 'done'; }, 'done');
    await check('compress', async () => { await call('Compress', 3000); return 'done'; }, 'done');
    await check('stop', async () => { await call('PlcStop'); return call('PlcStatus'); }, client.S7CpuStatusStop);
    await check('stop in STOP', () => call('PlcStop'), refused('already'));
    await check('no scan in STOP', async () => { const before = await call('MBRead', 200, 2); await pause(100); return (await call('MBRead', 200, 2)).equals(before); }, true);
    await check('warm start', async () => { await call('PlcHotStart'); return again(() => call('PlcStatus'), (got) => got === client.S7CpuStatusRun); }, client.S7CpuStatusRun);
    await check('start in RUN', () => call('PlcHotStart'), refused('already'));
    await check('cold start', async () => { await call('PlcStop'); await call('PlcColdStart'); return again(() => call('PlcStatus'), (got) => got === client.S7CpuStatusRun); }, client.S7CpuStatusRun);
    await check('what was copied to ROM are the initial values of a cold start', () => call('DBRead', 1, 4, 2), 'fff9');
}

async function secured() {
    await check('read variables', () => call('DBRead', 1, 4, 2), '04d2');
    await check('stop without the password', () => call('PlcStop'), refused(...LEVEL));
    await check('a wrong password', () => call('SetSessionPassword', 'wrong'), refused('password'));
    await check('the password', async () => { await call('SetSessionPassword', 'secret'); return 'entered'; }, 'entered');
    await check('stop with the password', async () => { await call('PlcStop'); return call('PlcStatus'); }, client.S7CpuStatusStop);
    await check('give the password back', async () => { await call('ClearSessionPassword'); return 'cleared'; }, 'cleared');
    await check('start without the password', () => call('PlcHotStart'), refused(...LEVEL));
}

(async () => {
    await check('connect', connect, 240);
    for (const part of process.argv[3] === 'protected' ? [secured] : [areas, many, identity, blocks, control]) await part();
    client.Disconnect();
    end();
})();
