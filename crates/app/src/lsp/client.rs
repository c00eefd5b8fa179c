//! What a client says of itself when it begins.

use std::path::PathBuf;

use lsp_types::{DidChangeWatchedFilesRegistrationOptions, FileSystemWatcher, GlobPattern};
use serde_json::{Value, json};
use sieben_lang::st::dialect::Dialect;
use sieben_model::cpu_type::CpuType;
use sieben_model::mnemonics::Mnemonics;
use sieben_workspace::project::Overrides;

use super::diagnostics::{PAGES, Telling};
use super::positions::Columns;
use super::uri;

/// What a client can do, as far as it matters.
#[derive(Clone, Debug)]
pub(super) struct Client {
    /// The process that started the server.
    pub(super) process: Option<u32>,
    /// The folders that it works in.
    pub(super) folders: Vec<PathBuf>,
    /// How it is told what is wrong.
    pub(super) telling: Telling,
    /// It asks for diagnostics, and does not want to be told.
    pub(super) pulls: bool,
    /// It can watch files.
    pub(super) watches: bool,
    /// It takes the word that its hints are old.
    pub(super) refreshes_hints: bool,
    /// It shows progress.
    pub(super) progress: bool,
    /// It takes lists of links with the place that they come from.
    pub(super) links: bool,
    /// It takes snippets.
    pub(super) snippets: bool,
    /// It takes edits with the versions of the texts.
    pub(super) versioned_edits: bool,
    /// It shows actions that cannot be done, with the reason.
    pub(super) disabled_actions: bool,
    /// What it says about all programs.
    pub(super) settings: Settings,
    /// What it said about them first.
    options: Value,
}

/// What a client sets for all programs, in `initializationOptions` or by `workspace/didChangeConfiguration`.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Settings {
    cpu: Option<&'static CpuType>,
    mnemonics: Option<Option<Mnemonics>>,
    dialect: Option<Dialect>,
    strict: bool,
    extended: bool,
    /// Whether hints show values of a run.
    pub(super) live_values: bool,
    /// What was not understood.
    pub(super) mistakes: Vec<String>,
}

impl Settings {
    /// Of the options that a client sends, with or without a `sieben` around them.
    pub(super) fn of(options: &Value) -> Self {
        let options = options.get("sieben").unwrap_or(options);
        let mut settings = Self::default();
        let text = |name: &str| options.get(name).and_then(Value::as_str).filter(|text| !text.is_empty());
        let flag = |name: &str| options.get(name).and_then(Value::as_bool);
        let mut mistakes = Vec::new();
        if let Some(name) = text("cpu") {
            settings.cpu = CpuType::by_name(name);
            if settings.cpu.is_none() {
                mistakes.push(format!("`cpu`: there is no CPU type `{name}`"));
            }
        }
        match text("mnemonics") {
            Some("auto") => settings.mnemonics = Some(None),
            Some("en") => settings.mnemonics = Some(Some(Mnemonics::English)),
            Some("de") => settings.mnemonics = Some(Some(Mnemonics::German)),
            Some(other) => mistakes.push(format!("`mnemonics`: `{other}` is none of `auto`, `en` and `de`")),
            None => {}
        }
        if let Some(name) = text("dialect") {
            settings.dialect = Dialect::from_name(name);
            if settings.dialect.is_none() {
                mistakes.push(format!("`dialect`: `{name}` is none of {}", Dialect::ALL.map(Dialect::name).join(", ")));
            }
        }
        settings.strict = flag("strict").unwrap_or_default();
        settings.extended = flag("extended").unwrap_or_default();
        settings.live_values = flag("liveValues").unwrap_or(true);
        settings.mistakes = mistakes;
        settings
    }

    /// How programs are compiled.
    pub(super) fn overrides(&self) -> Overrides {
        let Self { cpu, mnemonics, dialect, strict, extended, .. } = *self;
        Overrides { cpu, mnemonics, dialect, strict, extended, ..super::programs::usual() }
    }
}

impl Client {
    /// Reads the parameters of `initialize`. Clients leave out and spell out what they like: nothing of it is refused.
    pub(super) fn of(parameters: &Value) -> Self {
        let at = |path: &str| parameters.pointer(path);
        let can = |path: &str| at(&format!("/capabilities/{path}")).and_then(Value::as_bool).unwrap_or_default();
        let text = |path: &str| at(path).and_then(Value::as_str).unwrap_or_default().to_owned();
        let encodings = at("/capabilities/general/positionEncodings").and_then(Value::as_array).cloned().unwrap_or_default();
        let columns = if encodings.iter().any(|encoding| encoding == "utf-8") { Columns::Utf8 } else { Columns::Utf16 };
        let options = at("/initializationOptions").cloned().unwrap_or_default();
        let pages = Some(text("/initializationOptions/problemPages")).filter(|pages| !pages.is_empty());
        Self {
            process: at("/processId").and_then(Value::as_u64).and_then(|id| u32::try_from(id).ok()),
            folders: folders(parameters),
            telling: Telling {
                columns,
                pages: pages.unwrap_or_else(|| PAGES.to_owned()),
                related: can("textDocument/publishDiagnostics/relatedInformation"),
            },
            pulls: options.get("pullDiagnostics").and_then(Value::as_bool).unwrap_or_default(),
            watches: can("workspace/didChangeWatchedFiles/dynamicRegistration"),
            refreshes_hints: can("workspace/inlayHint/refreshSupport"),
            progress: can("window/workDoneProgress"),
            links: can("textDocument/definition/linkSupport"),
            snippets: can("textDocument/completion/completionItem/snippetSupport"),
            versioned_edits: can("workspace/workspaceEdit/documentChanges"),
            disabled_actions: can("textDocument/codeAction/disabledSupport"),
            settings: Settings::of(&options),
            options,
        }
    }

    /// The settings that hold from now on: what is not said stays as it was said first.
    pub(super) fn changed(&self, said: &Value) -> Settings {
        let inner = |options: &Value| options.get("sieben").unwrap_or(options).as_object().cloned().unwrap_or_default();
        let mut all = inner(&self.options);
        all.extend(inner(said));
        Settings::of(&Value::Object(all))
    }
}

/// The folders that a client works in: `workspaceFolders`, else `rootUri`, else `rootPath`, else none.
fn folders(parameters: &Value) -> Vec<PathBuf> {
    let list = parameters.get("workspaceFolders").and_then(Value::as_array);
    let mut folders: Vec<PathBuf> = list.into_iter().flatten().filter_map(|folder| uri::path_of(folder.get("uri")?.as_str()?)).collect();
    if folders.is_empty() {
        folders.extend(parameters.get("rootUri").and_then(Value::as_str).and_then(uri::path_of));
    }
    if folders.is_empty() {
        let path = parameters.get("rootPath").and_then(Value::as_str).map(PathBuf::from);
        folders.extend(path.filter(|path| path.is_absolute()));
    }
    folders
}

/// The kinds of semantic tokens, in the order of their numbers.
pub(super) const TOKEN_TYPES: [&str; 17] = [
    "comment",
    "keyword",
    "instruction",
    "label",
    "symbol",
    "variable",
    "parameter",
    "type",
    "function",
    "number",
    "string",
    "operator",
    "address",
    "block",
    "property",
    "event",
    "heading",
];

/// What tokens are besides, in the order of their bits.
pub(super) const TOKEN_MODIFIERS: [&str; 3] = ["declaration", "readonly", "modification"];

/// What the server can do.
pub(super) fn capabilities(client: &Client) -> Value {
    let encoding = match client.telling.columns {
        Columns::Utf8 => "utf-8",
        Columns::Utf16 => "utf-16",
    };
    let mut capabilities = json!({
        "positionEncoding": encoding,
        "textDocumentSync": { "openClose": true, "change": 2, "save": { "includeText": false } },
        "documentSymbolProvider": true,
        "foldingRangeProvider": true,
        "selectionRangeProvider": true,
        "documentFormattingProvider": true,
        "documentRangeFormattingProvider": true,
        "semanticTokensProvider": {
            "legend": { "tokenTypes": TOKEN_TYPES, "tokenModifiers": TOKEN_MODIFIERS },
            "full": true, "range": true,
        },
        "codeLensProvider": {},
        "hoverProvider": true,
        "completionProvider": { "triggerCharacters": [".", "#", "\"", "(", ",", ":"] },
        "signatureHelpProvider": { "triggerCharacters": ["(", ","], "retriggerCharacters": ["="] },
        "definitionProvider": true,
        "declarationProvider": true,
        "typeDefinitionProvider": true,
        "referencesProvider": true,
        "documentHighlightProvider": true,
        "renameProvider": { "prepareProvider": true },
        "linkedEditingRangeProvider": true,
        "inlayHintProvider": true,
        "callHierarchyProvider": true,
        "workspaceSymbolProvider": true,
        "codeActionProvider": { "codeActionKinds": ["quickfix", "refactor.extract", "refactor.rewrite", "source.fixAll.sieben"] },
        "executeCommandProvider": { "commands": super::executing::ALL },
        "workspace": { "workspaceFolders": { "supported": true, "changeNotifications": true } },
    });
    if client.pulls {
        capabilities["diagnosticProvider"] =
            json!({ "identifier": "sieben", "interFileDependencies": true, "workspaceDiagnostics": false });
    }
    capabilities
}

/// The files that a client is asked to watch.
pub(super) fn watched() -> Value {
    let pattern = "**/*.{awl,stl,st,iecst,scl,db,udt,lad,fbd,sdf,asc,dif,seq,csv,toml,awlpro,scenario}".to_owned();
    let watcher = FileSystemWatcher { glob_pattern: GlobPattern::String(pattern), kind: None };
    json!({ "registrations": [{
        "id": "files", "method": "workspace/didChangeWatchedFiles",
        "registerOptions": DidChangeWatchedFilesRegistrationOptions { watchers: vec![watcher] },
    }] })
}
