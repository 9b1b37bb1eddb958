namespace ErrorMatching.Nc;

/// <summary>Changes and inserts words of one block, in the style in which the block is written.</summary>
internal sealed class BlockEdit
{
    private readonly NcProgram _program;
    private readonly List<NcToken> _words = [];
    private readonly bool _programIsFixed;
    private readonly List<NcPatch> _patches = [];
    private readonly bool _spaced;
    private readonly bool _lowerCase;

    public BlockEdit(NcProgram program, NcBlock block, bool programIsFixed)
    {
        _program = program;
        _programIsFixed = programIsFixed;
        var anyWord = false;
        foreach (var token in program.Tokens(block))
        {
            if (token.Kind is NcTokenKind.Word or NcTokenKind.ExpressionWord)
            {
                _lowerCase |= !anyWord && program.Bytes.Span[token.Start] >= 'a';
                anyWord = true;
                _words.Add(token);
            }
            else
            {
                _spaced |= token.Kind == NcTokenKind.Space && anyWord;
            }
        }

        // A block of a single word does not show how it separates words; a space is always read.
        _spaced |= _words.Count < 2;
    }

    /// <summary>Patches in ascending order.</summary>
    public IReadOnlyList<NcPatch> Patches => [.. _patches.OrderBy(p => p.Start)];

    /// <summary>The value of a letter's word, or null where it has none.</summary>
    public NcNumber? Number(char letter) => Find(letter) is { } token ? token.Number : null;

    /// <summary>Gives a letter a new value: changes its word, or inserts one. A word that has the value already stays as it is spelled.</summary>
    public void Set(char letter, NcNumber value)
    {
        if (Find(letter) is not { } token)
        {
            Insert(letter, value);
        }
        else if (!token.Number.SameValue(value))
        {
            _patches.Add(new(token.ValueStart, token.ValueLength, StyleOf(token).Format(value)));
        }
    }

    /// <summary>Replaces a letter's word by others.</summary>
    public void Replace(char letter, params ReadOnlySpan<(char Letter, NcNumber Value)> by)
    {
        var token = Find(letter)!.Value;
        var bytes = new List<byte>();
        foreach (var (other, value) in by)
        {
            if (bytes.Count > 0 && _spaced)
            {
                bytes.Add((byte)' ');
            }

            bytes.Add(Spell(other));
            bytes.AddRange(StyleOf(token).Format(value));
        }

        _patches.Add(new(token.Start, token.Length, bytes.ToArray()));
    }

    private NumberStyle StyleOf(NcToken token) => NumberStyle.Of(_program.Bytes.Span.Slice(token.ValueStart, token.ValueLength), _programIsFixed) is var style && style.FixedDecimals > 0
        ? style
        : style with { FixedDecimals = -1 };

    private NcToken? Find(char letter)
    {
        foreach (var token in _words)
        {
            if (token.Letter == letter && token.Kind == NcTokenKind.Word)
            {
                return token;
            }
        }

        return null;
    }

    private byte Spell(char letter) => (byte)(_lowerCase ? char.ToLowerInvariant(letter) : letter);

    // Behind the block number, the codes and the axes that come first by custom (X Y Z, then I J K, then R).
    private void Insert(char letter, NcNumber value)
    {
        var order = Order(letter);
        var behind = -1;
        for (var i = 0; i < _words.Count; i++)
        {
            if (Order((char)_words[i].Letter) < order)
            {
                behind = i;
            }
        }

        var like = _words.FirstOrDefault(t => t.Kind == NcTokenKind.Word && Order((char)t.Letter) is >= 1 and <= 7);
        var style = like.Length > 0 ? StyleOf(like) : new NumberStyle(Plus: false, Point: true, LeadingZero: true, FixedDecimals: -1, WholeDigits: 1);
        byte[] word = [Spell(letter), .. style.Format(value)];
        var separator = _spaced ? " "u8 : default;
        _patches.Add(behind >= 0
            ? new(_words[behind].End, 0, (byte[])[.. separator, .. word])
            : new(_words[0].Start, 0, (byte[])[.. word, .. separator]));
    }

    private static int Order(char letter) => letter switch
    {
        'N' or 'G' or 'O' => 0,
        'X' => 1,
        'Y' => 2,
        'Z' => 3,
        'I' => 4,
        'J' => 5,
        'K' => 6,
        'R' => 7,
        _ => 8,
    };
}
