// What the grammars colour: each line of a source next to its pieces and their scopes.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from '@playwright/test';
import { ROOT } from './binary';
import { MANIFEST, shown, tokenized } from './grammar';

interface Case {
  readonly name: string;
  readonly language: string;
  /** A line, and what its pieces are; pieces without colour are left out. */
  readonly lines: readonly (readonly [string, string])[];
}

const CASES: readonly Case[] = [
  {
    name: "a comment ends with its line, and a title holds no comment",
    language: 'awl',
    lines: [
      ['      A     I 0.0; // open', 'A=keyword.other.instruction I 0.0=variable.other.address // open=comment.line.double-slash'],
      ['TITLE = a // b', 'TITLE=keyword.other.head ==keyword.operator.assignment a // b=markup.heading'],
      ['(* two', '(*=comment.block two=comment.block'],
      ['lines *) = Q 4.0', 'lines=comment.block *)=comment.block Q 4.0=variable.other.address'],
    ],
  },
  {
    name: "an instruction is one where a statement begins",
    language: 'awl',
    lines: [
      ['BEGIN', ''],
      ['      A A 0.0; A: A;', 'A=keyword.other.instruction A 0.0=variable.other.address A=entity.name.label :=punctuation.separator.label A=keyword.other.instruction'],
      ['      AN I 0.0 ; ON M 1.1 ;= Q 4.0', 'AN=keyword.other.instruction I 0.0=variable.other.address ON=keyword.other.instruction M 1.1=variable.other.address ==keyword.other.instruction Q 4.0=variable.other.address'],
      ['      U(', 'U(=keyword.other.instruction'],
      ['      O E 0.0', 'O=keyword.other.instruction E 0.0=variable.other.address'],
      ['      )', ')=keyword.other.instruction'],
      ['      ==I', '==I=keyword.other.instruction'],
      ['      +R; L STW; U OV; NOP 0', '+R=keyword.other.instruction L=keyword.other.instruction STW=variable.language.status U=keyword.other.instruction OV=variable.language.status NOP=keyword.other.instruction 0=constant.numeric'],
    ],
  },
  {
    name: "of words that begin alike the longest is taken",
    language: 'awl',
    lines: [
      ['BEGIN', ''],
      ['      SPBNB weg; SPBN weg; SPB weg; SPBB weg', 'SPBNB=keyword.control.jump weg=entity.name.label SPBN=keyword.control.jump weg=entity.name.label SPB=keyword.control.jump weg=entity.name.label SPBB=keyword.control.jump weg=entity.name.label'],
      ['      RNDX; RND+; RND; XOW; X M 0.0', 'RND+=keyword.other.instruction RND=keyword.other.instruction XOW=keyword.other.instruction X=keyword.other.instruction M 0.0=variable.other.address'],
    ],
  },
  {
    name: "a label is one with up to four characters, and a longer one is marked",
    language: 'awl',
    lines: [
      ['BEGIN', ''],
      ['Mär1: U "Tür offen";', 'Mär1=entity.name.label :=punctuation.separator.label U=keyword.other.instruction "Tür offen"=variable.other.symbol'],
      ['much_too_long: JC m001;', 'much_too_long=invalid.illegal.label :=punctuation.separator.label JC=keyword.control.jump m001=entity.name.label'],
      ['m001: BEB;', 'm001=entity.name.label :=punctuation.separator.label BEB=keyword.control.jump'],
    ],
  },
  {
    name: "declarations are no labels",
    language: 'awl',
    lines: [
      ['FUNCTION FC 1 : VOID', 'FUNCTION=keyword.control.block FC 1=entity.name.function VOID=support.type'],
      ['TITLE = T', 'TITLE=keyword.other.head ==keyword.operator.assignment T=markup.heading'],
      ['AUTHOR : me // him', 'AUTHOR=keyword.other.head me=string.unquoted // him=comment.line.double-slash'],
      ['{ S7_m_c := \'true\' }', '{ S7_m_c := \'true\' }=constant.other.attributes'],
      ['VAR_INPUT', 'VAR_INPUT=keyword.other.declaration'],
      ['  Tür : BOOL := TRUE;', 'Tür=variable.other.declaration BOOL=support.type :==keyword.operator.assignment TRUE=constant.language'],
      ['  a { S7_x := \'1\' } : ARRAY [1..3] OF INT;', 'a=variable.other.declaration { S7_x := \'1\' }=constant.other.attributes ARRAY=keyword.other.declaration 1=constant.numeric 3=constant.numeric OF=keyword.other.declaration INT=support.type'],
      ['END_VAR', 'END_VAR=keyword.other.declaration'],
      ['BEGIN', 'BEGIN=keyword.control.block'],
      ['END_FUNCTION', 'END_FUNCTION=keyword.control.block'],
    ],
  },
  {
    name: "the names of parameters are no instructions",
    language: 'awl',
    lines: [
      ['BEGIN', ''],
      ['      CALL FC 5 (', 'CALL=keyword.control.jump FC 5=entity.name.function (=punctuation.section.parameters'],
      ['         A := I 0.0,', 'A=variable.parameter :==keyword.operator.assignment I 0.0=variable.other.address'],
      ['         RET_VAL => MW 10);', 'RET_VAL=variable.parameter =>=keyword.operator.assignment MW 10=variable.other.address )=punctuation.section.parameters'],
      ['      CALL FB 1, DB 2', 'CALL=keyword.control.jump FB 1=entity.name.function DB 2=variable.other.address'],
      ['        S := I 0.0', 'S=variable.parameter :==keyword.operator.assignment I 0.0=variable.other.address'],
      ['      CALL "Block" (x := #y);', 'CALL=keyword.control.jump "Block"=variable.other.symbol (=punctuation.section.parameters x=variable.parameter :==keyword.operator.assignment #y=variable.other.local )=punctuation.section.parameters'],
    ],
  },
  {
    name: "operands: locals, symbols, constants, addresses, blocks",
    language: 'awl',
    lines: [
      ['BEGIN', ''],
      ['      L S5T#3S; L W#16#FF; L 2#1010; L P#M 1.0; L L#-5; L 1.5e+3; L P##Tür; L B#(1,2)', 'L=keyword.other.instruction S5T#3S=constant.numeric.typed L=keyword.other.instruction W#16#FF=constant.numeric.typed L=keyword.other.instruction 2#1010=constant.numeric.typed L=keyword.other.instruction P#M 1.0=constant.numeric.typed L=keyword.other.instruction L#-5=constant.numeric.typed L=keyword.other.instruction 1.5e+3=constant.numeric L=keyword.other.instruction P##Tür=constant.numeric.typed L=keyword.other.instruction B#(1,2)=constant.numeric.typed'],
      ['      L "a//b"; L #"Tür offen"; L \'it$\'s\'', 'L=keyword.other.instruction "a//b"=variable.other.symbol L=keyword.other.instruction #"Tür offen"=variable.other.local L=keyword.other.instruction \'=string.quoted.single it=string.quoted.single $\'=constant.character.escape s=string.quoted.single \'=string.quoted.single'],
      ['      L DB1.DBW 0; L MW [MD 10]; L PEW 256; U T 1; ZV Z 1; AUF DB 10; UC FC 1', 'L=keyword.other.instruction DB1.DBW 0=variable.other.address L=keyword.other.instruction MW=variable.other.address MD 10=variable.other.address L=keyword.other.instruction PEW 256=variable.other.address U=keyword.other.instruction T 1=variable.other.address ZV=keyword.other.instruction Z 1=variable.other.address AUF=keyword.other.instruction DB 10=variable.other.address UC=keyword.control.jump FC 1=entity.name.function'],
    ],
  },
  {
    name: "a network is written as it says",
    language: 'awl',
    lines: [
      ['BEGIN', ''],
      ['NETWORK KOP', 'NETWORK=keyword.control.network KOP=keyword.other.notation'],
      ['TITLE = Diagramm', 'TITLE=keyword.other.head ==keyword.operator.assignment Diagramm=markup.heading'],
      ['    OR', 'OR=keyword.control.branch'],
      ['      NC I 0.1', 'NC=keyword.other.element I 0.1=variable.other.address'],
      ['    END', 'END=keyword.control.branch'],
      ['    S_ODT T 1', 'S_ODT=support.function.box T 1=variable.other.address'],
      ['        TV := S5T#2S', 'TV=variable.parameter :==keyword.operator.assignment S5T#2S=constant.numeric.typed'],
      ['    CMP >I MW 10, 100', 'CMP=keyword.other.element >I=keyword.operator MW 10=variable.other.address 100=constant.numeric'],
      ['    COIL Q 4.0', 'COIL=keyword.other.element Q 4.0=variable.other.address'],
      ['NETWORK AWL', 'NETWORK=keyword.control.network AWL=keyword.other.notation'],
      ['      U E 0.0', 'U=keyword.other.instruction E 0.0=variable.other.address'],
    ],
  },
  {
    name: "a block that is not ended does not colour the next one",
    language: 'awl',
    lines: [
      ['FUNCTION FC 1 : VOID', 'FUNCTION=keyword.control.block FC 1=entity.name.function VOID=support.type'],
      ['BEGIN', 'BEGIN=keyword.control.block'],
      ['      A I 0.0', 'A=keyword.other.instruction I 0.0=variable.other.address'],
      ['DATA_BLOCK DB 1', 'DATA_BLOCK=keyword.control.block DB 1=entity.name.type'],
      ['  STRUCT', 'STRUCT=keyword.other.declaration'],
      ['    A : REAL;', 'A=variable.other.declaration REAL=support.type'],
      ['  END_STRUCT;', 'END_STRUCT=keyword.other.declaration'],
      ['BEGIN', 'BEGIN=keyword.control.block'],
      ['  A := 1.0;', ':==keyword.operator.assignment 1.0=constant.numeric'],
      ['END_DATA_BLOCK', 'END_DATA_BLOCK=keyword.control.block'],
    ],
  },
  {
    name: "a line of a diagram",
    language: 'lad',
    lines: [
      ['("Start" | "Pump") /"Stop" -> = "Pump"', '"Start"=variable.other.symbol |=keyword.operator "Pump"=variable.other.symbol /=keyword.operator "Stop"=variable.other.symbol ->=keyword.operator ==keyword.operator "Pump"=variable.other.symbol'],
      ['[MW 10 >I 100] { /I 0.1 SUB_I(MW 10, 100 => MW 12) -> = Q 4.1 ; -> S M 2.0 }', 'MW 10=variable.other.address >I=keyword.operator 100=constant.numeric /=keyword.operator I 0.1=variable.other.address SUB_I=support.function.box MW 10=variable.other.address 100=constant.numeric =>=keyword.operator.assignment MW 12=variable.other.address ->=keyword.operator ==keyword.operator Q 4.1=variable.other.address ->=keyword.operator S=keyword.other.element M 2.0=variable.other.address'],
      ['(I 0.0) S_ODT[T 5](TV := S5T#2S, R := I 0.7) -> = Q 4.0', 'I 0.0=variable.other.address S_ODT=support.function.box T 5=variable.other.address TV=variable.parameter :==keyword.operator.assignment S5T#2S=constant.numeric.typed R=variable.parameter :==keyword.operator.assignment I 0.7=variable.other.address ->=keyword.operator ==keyword.operator Q 4.0=variable.other.address'],
    ],
  },
  {
    name: "statements, functions and values of SCL",
    language: 'scl',
    lines: [
      ['IF #x > 3 AND NOT "DB".value THEN #y := SIN(#x) ** 2; END_IF;', 'IF=keyword.control #x=variable.other.local >=keyword.operator 3=constant.numeric AND=keyword.operator.word NOT=keyword.operator.word "DB"=variable.other.symbol THEN=keyword.control #y=variable.other.local :==keyword.operator.assignment SIN=support.function #x=variable.other.local **=keyword.operator 2=constant.numeric END_IF=keyword.control'],
      ['REGION Größe ändern', 'REGION=keyword.control Größe ändern=entity.name.section'],
      ['END_REGION', 'END_REGION=keyword.control'],
      ['floor := 1; z := floor + 1; f := FLOOR(x);', ':==keyword.operator.assignment 1=constant.numeric :==keyword.operator.assignment +=keyword.operator 1=constant.numeric :==keyword.operator.assignment FLOOR=support.function'],
      ['MW10 := WORD_TO_INT(E0.0); s := \'a$\'b\';', 'MW10=variable.other.address :==keyword.operator.assignment WORD_TO_INT=support.function E0.0=variable.other.address :==keyword.operator.assignment \'=string.quoted.single a=string.quoted.single $\'=constant.character.escape b=string.quoted.single \'=string.quoted.single'],
      ['DB10.DBW2 := FC10(a := 1);', 'DB10.DBW2=variable.other.address :==keyword.operator.assignment FC10=entity.name.function a=variable.parameter :==keyword.operator.assignment 1=constant.numeric'],
    ],
  },
  {
    name: "comments of SCL hold others, and go over lines",
    language: 'scl',
    lines: [
      ['(* a (* b *) c *) x := 1; /* d', '(*=comment.block a=comment.block (*=comment.block b=comment.block *)=comment.block c=comment.block *)=comment.block :==keyword.operator.assignment 1=constant.numeric /*=comment.block d=comment.block'],
      ['e */ y := 2;', 'e=comment.block */=comment.block :==keyword.operator.assignment 2=constant.numeric'],
    ],
  },
  {
    name: "declarations and parameters of SCL",
    language: 'scl',
    lines: [
      ['FUNCTION_BLOCK "Regler"', 'FUNCTION_BLOCK=keyword.control.block "Regler"=entity.name.function'],
      ['VERSION : 0.1', 'VERSION=keyword.other.head 0.1=constant.numeric'],
      ['VAR_INPUT RETAIN', 'VAR_INPUT=keyword.other.declaration RETAIN=keyword.other.head'],
      ['  x { S7_x := \'true\' } : Real := 1.5;', 'x=variable.other.declaration { S7_x := \'true\' }=constant.other.attributes Real=support.type :==keyword.operator.assignment 1.5=constant.numeric'],
      ['  t : TON;', 't=variable.other.declaration TON=support.type'],
      ['END_VAR', 'END_VAR=keyword.other.declaration'],
      ['BEGIN', 'BEGIN=keyword.control.block'],
      ['t(IN := %I0.0,', 't=entity.name.function IN=variable.parameter :==keyword.operator.assignment %I0.0=variable.other.address'],
      ['  PT := T#5s,', 'PT=variable.parameter :==keyword.operator.assignment T#5s=constant.numeric.typed'],
      ['  Q => #z);', 'Q=variable.parameter =>=keyword.operator.assignment #z=variable.other.local'],
    ],
  },
  {
    name: "tests and the dialects of ST",
    language: 'st',
    lines: [
      ['TEST \'the motor starts\'', 'TEST=keyword.control.block \'the motor starts\'=entity.name.function.test'],
      ['  ASSERT_EQ(%QW4, 16#0025, \'why\');', 'ASSERT_EQ=support.function.test %QW4=variable.other.address 16#0025=constant.numeric.typed \'=string.quoted.single why=string.quoted.single \'=string.quoted.single'],
      ['  "START" := TRUE; SCAN(1);', '"START"=variable.other.symbol :==keyword.operator.assignment TRUE=constant.language SCAN=support.function.test 1=constant.numeric'],
      ['END_TEST', 'END_TEST=keyword.control.block'],
      ['FUNCTION_BLOCK FINAL Motor EXTENDS Base', 'FUNCTION_BLOCK=keyword.control.block Motor=entity.name.function EXTENDS=keyword.other.head'],
      ['METHOD PUBLIC runs : BOOL', 'METHOD=keyword.control.block runs=entity.name.function BOOL=support.type'],
      ['c := Colour#Red; n := INT#5;', ':==keyword.operator.assignment Colour#Red=constant.other.enumeration :==keyword.operator.assignment INT#5=constant.numeric.typed'],
    ],
  },
  {
    name: "data blocks",
    language: 's7db',
    lines: [
      ['DATA_BLOCK "Rezept"', 'DATA_BLOCK=keyword.control.block "Rezept"=entity.name.function'],
      ['{ S7_Optimized_Access := \'TRUE\' }', '{ S7_Optimized_Access := \'TRUE\' }=constant.other.attributes'],
      ['NON_RETAIN', 'NON_RETAIN=keyword.other.head'],
      ['   STRUCT', 'STRUCT=keyword.other.declaration'],
      ['      menge : Int := 5;   // Liter', 'menge=variable.other.declaration Int=support.type :==keyword.operator.assignment 5=constant.numeric // Liter=comment.line.double-slash'],
      ['   END_STRUCT;', 'END_STRUCT=keyword.other.declaration'],
      ['BEGIN', 'BEGIN=keyword.control.block'],
      ['   menge := 7;', ':==keyword.operator.assignment 7=constant.numeric'],
      ['END_DATA_BLOCK', 'END_DATA_BLOCK=keyword.control.block'],
    ],
  },
  {
    name: "data types",
    language: 's7udt',
    lines: [
      ['TYPE "Motor"', 'TYPE=keyword.control.block "Motor"=entity.name.function'],
      ['VERSION : 0.1', 'VERSION=keyword.other.head 0.1=constant.numeric'],
      ['  STRUCT', 'STRUCT=keyword.other.declaration'],
      ['    speed : INT;', 'speed=variable.other.declaration INT=support.type'],
      ['  END_STRUCT;', 'END_STRUCT=keyword.other.declaration'],
      ['END_TYPE', 'END_TYPE=keyword.control.block'],
    ],
  },
];

for (const { name, language, lines } of CASES) {
  test(`${language}: ${name}`, async () => {
    const text = lines.map(([line]) => line).join('\n');
    const found = await shown(language, text);
    expect(lines.map(([line], index) => [line, found[index]])).toEqual(lines);
  });
}

/** Milliseconds of the processor since then: other programs on the machine do not count. */
function spent(begun: NodeJS.CpuUsage): number {
  const { user, system } = process.cpuUsage(begun);
  return (user + system) / 1000;
}

/** The mnemonics of the instruction list, in both languages, with those that direct the flow of statements. */
function mnemonics(): string[] {
  const page = readFileSync(join(ROOT, 'docs/reference/instructions.md'), 'utf8');
  const rows = page.split('\n').filter((line) => line.startsWith('| `'));
  return [...new Set(rows.flatMap((row) => [...row.matchAll(/^\| `(.+?)` \| `(.+?)` \|/gu)].flatMap((found) => [found[1] ?? '', found[2] ?? ''])))];
}

test('every instruction of the table is coloured whole, in any case of its letters', async () => {
  const all = mnemonics();
  expect(all.length).toBeGreaterThan(150);
  const lines = all.flatMap((word) => [`      ${word}`, `m1: ${word.toLowerCase()} `]);
  const pieces = await tokenized('awl', ['BEGIN', ...lines].join('\n'));
  const wrong = lines.filter((line, index) => {
    const word = line.replace('m1:', '').trim();
    return !(pieces[index + 1] ?? []).some(({ text, scopes }) => text.trim() === word && /^keyword\.(?:other\.instruction|control\.jump)\./u.test(scopes.at(-1) ?? ''));
  });
  expect(wrong).toEqual([]);
});

test('no source of the project keeps a grammar busy or breaks it', async () => {
  const folders = readdirSync(join(ROOT, 'examples'), { withFileTypes: true }).filter((entry) => entry.isDirectory());
  const files = folders.flatMap(({ name }) => readdirSync(join(ROOT, 'examples', name)).map((file) => join(ROOT, 'examples', name, file)));
  for (const file of files) {
    const ending = /\.(awl|scl|st|lad|fbd)$/u.exec(file)?.[1];
    if (ending === undefined) continue;
    const text = readFileSync(file, 'utf8');
    const begun = process.cpuUsage();
    const lines = await tokenized(ending, text);
    expect(lines.map((pieces) => pieces.map((piece) => piece.text).join('')).join('\n')).toBe(text.replaceAll('\r\n', '\n'));
    expect(spent(begun), file).toBeLessThan(3_000);
  }
});

test('hostile lines are coloured in time', async () => {
  for (const part of ['"', "'", '(', '(*', 'A:', '#', 'x := ', 'P#', '{', ' ', 'ä', '1.', 'DB1.', 'CALL (', 'x{']) {
    for (const language of new Set(MANIFEST.contributes.grammars.flatMap((grammar) => grammar.language ?? []))) {
      const begun = process.cpuUsage();
      await tokenized(language, part.repeat(2_000));
      expect(spent(begun), `${language}: ${part}`).toBeLessThan(5_000);
    }
  }
});

test('fences of Markdown are coloured as their language', async () => {
  const [, statement] = await tokenized('markdown.sieben.codeblock', '```stl\n      A     I 0.0\n```');
  expect(statement?.some(({ text, scopes }) => text === 'A' && scopes.includes('keyword.other.instruction.awl'))).toBe(true);
});
