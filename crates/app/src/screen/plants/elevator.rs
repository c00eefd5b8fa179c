//! The elevator: the shaft with its car and door, the buttons and lamps of each floor beside it.

use ratatui::style::Color;

use super::canvas::{Canvas, cells};
use super::terminals;
use super::view::View;
use super::{Picture, Size, Sizes};
use crate::screen::columns::fitted;

pub(super) const PICTURE: Picture =
    Picture { kind: "elevator", sizes: Sizes { least: Size { width: 40, height: 11 }, best: Size { width: 60, height: 20 } }, draw };

/// Columns of the shaft between its walls.
const SHAFT: usize = 7;
/// What every floor has: what stands above the column, and the name before `_1`.
const OF_FLOORS: [(&str, &str); 4] = [("at", "floor"), ("call", "call"), ("car", "car"), ("lamp", "lamp")];
/// What stands in a column at the right, with words for a narrow one.
const OTHERS: [(&str, &str); 8] = [
    ("near_floor", "near"),
    ("limit", "lim"),
    ("door_open", "open"),
    ("door_shut", "shut"),
    ("emergency", "stop"),
    ("barrier", "beam"),
    ("alarm", "alrm"),
    ("display", ""),
];

fn draw(canvas: &mut Canvas<'_>, view: &View<'_>) {
    let large = canvas.holds(PICTURE.sizes.best);
    // A floor is so many rows high; each of the four things that it has takes so many columns.
    let (rows, columns) = if large { (4, 7) } else { (2, 4) };
    let bottom = shaft(canvas, view, rows);
    buttons(canvas, view, rows, columns);

    let list = 12 + 4 * columns;
    let room = canvas.width().saturating_sub(list);
    for (row, (name, word)) in OTHERS.into_iter().enumerate() {
        match large {
            true => terminals::named(canvas, view, (list, row, room), name),
            false => terminals::called(canvas, view, (list, row, room), (name, word)),
        }
    }
    if large {
        for (row, name) in ["position", "up", "down", "fast", "opening", "shutting"].into_iter().enumerate() {
            terminals::named(canvas, view, (list, OTHERS.len() + row, room), name);
        }
        canvas.text(list, OTHERS.len() + 7, &format!("{:.2} m, door {:.0} %", view.state("position"), view.state("door")));
        canvas.text(list, OTHERS.len() + 8, &format!("{:.1} m travelled", view.state("travelled")));
        warnings(canvas, view, (12, bottom));
        terminals::faults(canvas, view, (0, bottom + 1, canvas.width()), 2);
        return;
    }
    // Motor and door with their addresses alone, in one line.
    let mut x = 0;
    for (name, sign) in [("up", "▲"), ("down", "▼"), ("fast", "»"), ("opening", "<>"), ("shutting", "><")] {
        let address = view.address(name).replace(' ', "");
        canvas.text(x, bottom + 1, &address);
        x += address.len();
        canvas.lamp(x, bottom + 1, view.lit(name), Color::Green);
        let mark = if view.fails(name) { "✗" } else { sign };
        canvas.text(x + 1, bottom + 1, mark);
        x += 2 + sign.chars().count();
    }
    let position = format!("{} {}", view.address("position"), view.word("position"));
    canvas.text(0, bottom + 2, &position);
    canvas.styled(position.len(), bottom + 2, if view.fails("position") { "✗" } else { " " }, canvas.bold(Color::Red));
    if view.faults().is_empty() {
        warnings(canvas, view, (13, bottom + 2));
    }
    terminals::faults(canvas, view, (13, bottom + 2, canvas.width().saturating_sub(13)), 1);
}

/// What must not happen, if it did.
fn warnings(canvas: &mut Canvas<'_>, view: &View<'_>, (x, y): (usize, usize)) {
    let red = canvas.colour(Color::Red);
    let open = view.state("open_travel");
    let hits = view.state("buffer_hits");
    if open > 0.0 {
        canvas.styled(x, y, &format!("✗ {open:.2} m open"), red);
    }
    if hits > 0.0 {
        canvas.styled(x + 13, y, &format!("✗ buffer {hits:.0}×"), red);
    }
}

/// The shaft, its car and the door; gives the row of its floor.
fn shaft(canvas: &mut Canvas<'_>, view: &View<'_>, rows: usize) -> usize {
    let (floors, height) = (4, view.parameter("height").max(0.1));
    let top = usize::from(rows > 2);
    let bottom = top + floors * rows;
    for row in top..bottom {
        let floor = (bottom - 1 - row) / rows + 1;
        let at_floor = (bottom - 1 - row).is_multiple_of(rows);
        canvas.faint_text(0, row, &if at_floor { floor.to_string() } else { " ".to_owned() });
        canvas.text(1, row, if at_floor { "╶┤" } else { " │" });
        canvas.text(3 + SHAFT, row, if at_floor { "├" } else { "│" });
    }
    canvas.text(2, bottom, &format!("╰{}╯", "─".repeat(SHAFT)));
    // The floor of the car is on the row of the floor that it stands at.
    let up = (view.state("position") / height * rows as f64).round().clamp(0.0, (floors * rows - 1) as f64) as usize;
    let car = bottom - 1 - up;
    let open = cells(view.state("door") / 100.0, 3);
    let leaf = "█".repeat(3 - open);
    let door = format!("{leaf}{}{leaf}", " ".repeat(SHAFT - 2 * leaf.chars().count()));
    let style = canvas.bold(Color::Cyan);
    let first = car.saturating_sub(rows / 2 - 1).max(top);
    for row in first..=car {
        canvas.styled(3, row, &door, style);
    }
    let way = match (view.is_on("up"), view.is_on("down")) {
        (true, false) => "▲",
        (false, true) => "▼",
        _ => " ",
    };
    canvas.styled(3 + SHAFT / 2, car, if way == " " && open > 0 { "·" } else { way }, canvas.bold(Color::Yellow));
    if view.is_on("barrier") {
        canvas.styled(3 + SHAFT / 2, car, "☻", canvas.bold(Color::Magenta));
    }
    for row in top..first {
        canvas.faint_text(3 + SHAFT / 2, row, "┊");
    }
    bottom
}

/// A column for each thing that every floor has.
fn buttons(canvas: &mut Canvas<'_>, view: &View<'_>, rows: usize, columns: usize) {
    let top = usize::from(rows > 2);
    for (column, (head, name)) in OF_FLOORS.into_iter().enumerate() {
        let x = 12 + column * columns;
        if top > 0 {
            canvas.faint_text(x, 0, head);
        }
        for floor in 1..=4_usize {
            let name = format!("{name}_{floor}");
            let y = top + (5 - floor) * rows - 1;
            let colour = if column == 3 { Color::Yellow } else { Color::Green };
            canvas.lamp(x, y, view.lit(&name), colour);
            if view.fails(&name) {
                canvas.styled(x + 1, y, "✗", canvas.bold(Color::Red));
            }
            let address = view.address(&name);
            if rows > 2 {
                canvas.faint_text(x, y - 1, &address);
                let label = view.signal(&name).map_or("", |signal| view.label(signal));
                if label != name {
                    canvas.faint_text(x, y - 2, &fitted(label, columns - 1));
                }
            } else {
                // Without its letter, which stands below the column.
                canvas.faint_text(x, y - 1, address.trim_start_matches(|c: char| !c.is_ascii_digit()));
                canvas.faint_text(x, top + 4 * rows, if column == 3 { "Q" } else { "I" });
            }
        }
    }
}
