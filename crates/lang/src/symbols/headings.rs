//! What the columns of a table are called: in our files, in those of other tools, and in the languages of courses and plants.

/// The columns that mean something, in their usual order; the first two are required, the last four belong to the assignment table.
pub const COLUMNS: [&str; 8] = ["symbol", "address", "type", "comment", "number", "unit", "tag", "remark"];

/// The columns of the assignment table where it has no header, in its usual order: number, address, unit, technological name, description, remark.
pub(super) const OF_ASSIGNMENTS: [&str; 6] = ["number", "address", "unit", "symbol", "comment", "remark"];

/// The places of some columns in [`COLUMNS`].
pub(super) const SYMBOL: usize = 0;
pub(super) const ADDRESS: usize = 1;
pub(super) const NUMBER: usize = 4;
pub(super) const UNIT: usize = 5;
const TAG: usize = 6;

/// Other names of each column, in letters and digits only: English, German, Slovene, Croatian, Estonian, Russian, French, Spanish, Italian, Polish, Czech, Hungarian, Korean.
const OTHERS: [&[&str]; 8] = [
    &[
        "name",
        "symbolname",
        "symbolic name",
        "bezeichner",
        "simbol",
        "ime",
        "sümbol",
        "nimi",
        "символ",
        "имя",
        "symbole",
        "nom",
        "mnémonique",
        "símbolo",
        "simbolo",
        "nombre",
        "nome",
        "nazwa",
        "jméno",
        "szimbólum",
        "név",
        "기호",
        "이름",
    ],
    &[
        "addr",
        "adresse",
        "adr",
        "logicaladdress",
        "logischeadresse",
        "absoluteaddress",
        "absolutadresse",
        "operand",
        "naslov",
        "adresa",
        "aadress",
        "адрес",
        "dirección",
        "direccion",
        "indirizzo",
        "adres",
        "cím",
        "주소",
    ],
    &[
        "datatype",
        "datentyp",
        "typ",
        "tip",
        "podatkovnitip",
        "tippodatka",
        "tüüp",
        "andmetüüp",
        "тип",
        "типданных",
        "typededonnées",
        "typededonnees",
        "tipo",
        "tipodedatos",
        "tipodidato",
        "tipodato",
        "típus",
        "자료형",
    ],
    &[
        "kommentar",
        "description",
        "beschreibung",
        "bedeutung",
        "funktion",
        "function",
        "opis",
        "komentar",
        "kirjeldus",
        "kommentaar",
        "selgitus",
        "описание",
        "комментарий",
        "назначение",
        "commentaire",
        "descripción",
        "descripcion",
        "comentario",
        "descrizione",
        "commento",
        "komentarz",
        "popis",
        "komentář",
        "leírás",
        "설명",
    ],
    &[
        "no",
        "nr",
        "num",
        "n",
        "nº",
        "lfdnr",
        "laufendenummer",
        "nummer",
        "št",
        "zapšt",
        "številka",
        "rbr",
        "redbr",
        "jrk",
        "jrknr",
        "jnr",
        "номер",
        "ппномер",
        "пп",
        "numéro",
        "numero",
        "núm",
        "número",
        "lp",
        "č",
        "čís",
        "sorszám",
        "ssz",
        "번호",
    ],
    &[
        "units",
        "einheit",
        "enota",
        "jedinica",
        "ühik",
        "единица",
        "единицаизмерения",
        "единицыизмерения",
        "едизм",
        "unité",
        "unite",
        "unidad",
        "unità",
        "unita",
        "jednostka",
        "jednotka",
        "mértékegység",
        "egység",
        "단위",
    ],
    &[
        "technologicalname",
        "techname",
        "technologicaldesignation",
        "designation",
        "technologischername",
        "bezeichnung",
        "betriebsmittel",
        "technologischebezeichnung",
        "techbezeichnung",
        "bmk",
        "betriebsmittelkennzeichen",
        "tehnološkaoznaka",
        "tehnoloskaoznaka",
        "tehnoloznaka",
        "tehoznaka",
        "oznaka",
        "tähis",
        "tehnoloogilinetähis",
        "tähistus",
        "обозначение",
        "технологическоеобозначение",
        "технологическоеимя",
        "désignation",
        "nomtechnologique",
        "repère",
        "repere",
        "designación",
        "designacion",
        "denominación",
        "nombretecnológico",
        "sigla",
        "designazione",
        "denominazione",
        "nometecnologico",
        "oznaczenie",
        "označení",
        "jelölés",
        "기호명",
    ],
    &[
        "remarks",
        "note",
        "notes",
        "bemerkung",
        "bemerkungen",
        "anmerkung",
        "hinweis",
        "opomba",
        "opombe",
        "napomena",
        "märkus",
        "märkused",
        "примечание",
        "примечания",
        "remarque",
        "remarques",
        "observación",
        "observacion",
        "observaciones",
        "nota",
        "osservazione",
        "osservazioni",
        "uwaga",
        "uwagi",
        "poznámka",
        "megjegyzés",
        "비고",
    ],
];

/// A heading in letters and digits only, small: `Teh nol. oznaka` is `tehnoloznaka`.
fn plain(heading: &str) -> String {
    if heading.trim() == "№" {
        return "no".to_owned();
    }
    heading.chars().filter(|letter| letter.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// The column that other tools and languages mean with a heading.
fn other(heading: &str) -> Option<usize> {
    let heading = plain(heading);
    OTHERS.iter().position(|names| names.iter().any(|name| plain(name) == heading))
}

/// Which known column each header is; a second one of the same name counts as unknown. Other names count where ours are missing.
///
/// Where no column is the symbol, the technological name is.
pub(super) fn column_kinds(columns: &[String]) -> Vec<Option<usize>> {
    let mut kinds: Vec<Option<usize>> = Vec::with_capacity(columns.len());
    for column in columns {
        let kind = COLUMNS.iter().position(|known| column.trim().eq_ignore_ascii_case(known));
        kinds.push(kind.filter(|_| !kinds.contains(&kind)));
    }
    let others: Vec<Option<usize>> = columns.iter().map(|column| other(column)).collect();
    let has_symbol = kinds.contains(&Some(SYMBOL)) || others.contains(&Some(SYMBOL));
    for (index, &other) in others.iter().enumerate() {
        let kind = other.map(|kind| if kind == TAG && !has_symbol { SYMBOL } else { kind });
        if kinds[index].is_none() && !kinds.contains(&kind) {
            kinds[index] = kind;
        }
    }
    if !kinds.contains(&Some(SYMBOL))
        && let Some(tag) = kinds.iter_mut().find(|kind| **kind == Some(TAG))
    {
        *tag = Some(SYMBOL);
    }
    kinds
}

/// Whether these cells are names of columns, symbol and address among them.
pub(crate) fn are_headings(cells: &[String]) -> bool {
    let kinds = column_kinds(cells);
    kinds.contains(&Some(SYMBOL)) && kinds.contains(&Some(ADDRESS))
}

/// Whether a field is the dash that tables have where there is nothing.
pub(super) fn is_dash(field: &str) -> bool {
    matches!(field.trim(), "-" | "–" | "—" | "−" | "‐" | "‑")
}
