namespace ErrorMatching.Hmi;

/// <summary>The keys of the keyboard on the screen, row by row. Letters and signs have all printable characters of ASCII between them,
/// because a password may have any.</summary>
/// <param name="Rows">The rows. The widths of their keys add up to the same number of columns.</param>
internal sealed record KeyboardLayout(IReadOnlyList<IReadOnlyList<BoardKey>> Rows)
{
    /// <summary>Letters in the order of English keyboards, with the digits above.</summary>
    public static KeyboardLayout Letters { get; } = new(
        [
            [.. Typing("1234567890"), new(BoardAct.Erase, Width: 4)],
            [.. Typing("qwertyuiop-_")],
            [.. Typing("asdfghjkl."), new(BoardAct.Enter, Width: 4)],
            [new(BoardAct.Shift, Width: 4), .. Typing("zxcvbnm,/:")],
            Last(BoardAct.Signs),
        ]);

    /// <summary>Signs. What letters and signs have in common is in the same places.</summary>
    public static KeyboardLayout Signs { get; } = new(
        [
            Letters.Rows[0],
            [.. Typing("!\"#$%&'()*=?")],
            [.. Typing("+;<>[]\\^`."), new(BoardAct.Enter, Width: 4)],
            [.. Typing("-_{|}~°µ€,/:")],
            Last(BoardAct.Letters),
        ]);

    /// <summary>Digits, for numbers. It has as many rows as the others, so that nothing moves when it changes.</summary>
    public static KeyboardLayout Numbers { get; } = new(
        [
            [.. Typing("789"), new(BoardAct.Erase)],
            [.. Typing("456-")],
            [.. Typing("123"), new(BoardAct.Enter)],
            [new(BoardAct.Left), .. Typing("0."), new(BoardAct.Right)],
            [new(BoardAct.Letters, Width: 4), new(BoardAct.Close, Width: 4)],
        ]);

    private static IReadOnlyList<BoardKey> Last(BoardAct other) =>
        [
            new(other, Width: 3), new(BoardAct.Numbers, Width: 3), new(BoardAct.Left), new(BoardAct.Space, Width: 9), new(BoardAct.Right),
            .. Typing("@"), new(BoardAct.Close, Width: 3)
        ];

    private static IEnumerable<BoardKey> Typing(string characters) => characters.Select(c => new BoardKey(BoardAct.Type, c.ToString()));
}

/// <summary>What a key of the keyboard on the screen does.</summary>
internal enum BoardAct
{
    /// <summary>Types its character.</summary>
    Type,

    /// <summary>Types a space.</summary>
    Space,

    /// <summary>Makes the next letter a capital; twice, all letters.</summary>
    Shift,

    /// <summary>Erases the character before the caret, or what is selected.</summary>
    Erase,

    /// <summary>Moves the caret to the left.</summary>
    Left,

    /// <summary>Moves the caret to the right.</summary>
    Right,

    /// <summary>What Enter does in the field.</summary>
    Enter,

    /// <summary>Changes to letters.</summary>
    Letters,

    /// <summary>Changes to signs.</summary>
    Signs,

    /// <summary>Changes to numbers.</summary>
    Numbers,

    /// <summary>Closes the keyboard.</summary>
    Close,
}

/// <summary>A key of the keyboard on the screen.</summary>
/// <param name="Act">What it does.</param>
/// <param name="Text">The character that it types; empty for other acts.</param>
/// <param name="Width">Its width in columns of the layout.</param>
internal sealed record BoardKey(BoardAct Act, string Text = "", int Width = 2)
{
    /// <summary>Its identifier, the same for a small letter and its capital.</summary>
    public string AutomationId => "key-" + (Act == BoardAct.Type ? Text : Act.ToString().ToLowerInvariant());

    /// <summary>The character that it types.</summary>
    /// <param name="isShifted">True for a capital.</param>
    public string Typed(bool isShifted) => Act == BoardAct.Space ? " " : isShifted ? Text.ToUpperInvariant() : Text;
}
