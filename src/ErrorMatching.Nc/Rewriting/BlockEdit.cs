namespace ErrorMatching.Nc;

/// <summary>Changes and inserts words of one block in the block's own style. Reusable for many blocks.</summary>
internal sealed class BlockEdit
{
    private readonly NcProgram _program;
    private readonly PatchText _text = new();
    private readonly int[] _placeOf = new int[32];
    private readonly List<NcPatch> _patches = [];
    private readonly bool _programIsFixed;
    private readonly bool _keywordsLead;
    private readonly int _incrementDecimals;
    private NcToken[] _words = new NcToken[16];
    private int _wordCount;
    private bool _isSorted = true;
    private bool _spaced;
    private bool _lowerCase;

    /// <summary>Creates an edit for a program's blocks.</summary>
    /// <param name="program">The program.</param>
    /// <param name="programIsFixed">True if the program pads its numbers with zeros.</param>
    /// <param name="incrementDecimals">Decimals of the unit of a number without a point; -1 if it counts whole units.</param>
    public BlockEdit(NcProgram program, bool programIsFixed, int incrementDecimals)
    {
        _program = program;
        _programIsFixed = programIsFixed;
        _incrementDecimals = incrementDecimals;
        _keywordsLead = !LanguageSpelling.HasCodesIn(program.Syntax);
    }

    /// <summary>Creates an edit for other blocks of the same program.</summary>
    public BlockEdit(BlockEdit other)
        : this(other._program, other._programIsFixed, other._incrementDecimals)
    {
    }

    /// <summary>Most decimals, up to six, of the coordinates and centers of all opened blocks, and whether any of them was padded with
    /// zeros.</summary>
    public (int Decimals, bool IsFixed) Spelling { get; private set; }

    /// <summary>Patches of the block, in ascending order.</summary>
    public List<NcPatch> Patches
    {
        get
        {
            if (!_isSorted)
            {
                _patches.Sort((a, b) => a.Start.CompareTo(b.Start));
                _isSorted = true;
            }

            return _patches;
        }
    }

    /// <summary>Starts another block.</summary>
    public void Open(NcBlock block)
    {
        _patches.Clear();
        Array.Clear(_placeOf);
        (_wordCount, _isSorted, _spaced, _lowerCase) = (0, true, false, false);
        foreach (ref readonly var token in _program.Tokens(block))
        {
            if (token.Kind is NcTokenKind.Word or NcTokenKind.ExpressionWord)
            {
                _lowerCase |= _wordCount == 0 && _program.Bytes.Span[token.Start] >= 'a';
                Spelling = SpellingWith(Spelling, token);
                Add(token);
            }
            else if (token.Kind == NcTokenKind.Keyword && _keywordsLead && _wordCount <= 1 && (_wordCount == 0 || _words[0].Letter == 'N'))
            {
                // Words follow the path function of a block.
                Add(token);
            }
            else
            {
                _spaced |= token.Kind == NcTokenKind.Space && _wordCount > 0;
            }
        }

        // A block of one word does not show how it separates words; a space is always valid.
        _spaced |= _wordCount < 2;
    }

    /// <summary>Adds the spelling of blocks that another edit opened.</summary>
    public void Join(BlockEdit other) =>
        Spelling = (Math.Max(Spelling.Decimals, other.Spelling.Decimals), Spelling.IsFixed | other.Spelling.IsFixed);

    /// <summary>The spelling of coordinates and centers after one more token.</summary>
    public static (int Decimals, bool IsFixed) SpellingWith((int Decimals, bool IsFixed) others, in NcToken token) =>
        token is { Kind: NcTokenKind.Word, Letter: >= (byte)'X' and <= (byte)'Z' or >= (byte)'I' and <= (byte)'K' }
            ? (
                Math.Max(others.Decimals, Math.Min(6, token.Number.Decimals)),
                others.IsFixed | (token.Number.Decimals > 1 && token.Number.Digits % 10 == 0))
            : others;

    // Stores the place of the first word of each letter, counted from 1.
    private void Add(in NcToken token)
    {
        if (_wordCount == _words.Length)
        {
            Array.Resize(ref _words, _wordCount * 2);
        }

        _words[_wordCount++] = token;
        var letter = token.Letter - 'A';
        if (token.Kind == NcTokenKind.Word && (uint)letter < (uint)_placeOf.Length && _placeOf[letter] == 0)
        {
            _placeOf[letter] = _wordCount;
        }
    }

    /// <summary>The value of a letter's word; null if there is none.</summary>
    public NcNumber? Number(byte letter) => PlaceOf(letter) is >= 0 and var place ? ValueOf(_words[place]) : null;

    /// <summary>Whether a word that the control computes is a position or an increment; null if the letter has no such word.</summary>
    public WordDistance? Computed(byte letter)
    {
        foreach (ref readonly var word in _words.AsSpan(0, _wordCount))
        {
            if (word.Kind == NcTokenKind.ExpressionWord && word.Letter == letter)
            {
                return word.Distance;
            }
        }

        return null;
    }

    /// <summary>Adds a number to a word that the control computes.</summary>
    /// <returns>False if the program's spelling has no place for a sum.</returns>
    public bool Add(byte letter, NcNumber constant)
    {
        foreach (ref readonly var word in _words.AsSpan(0, _wordCount))
        {
            if (word.Kind != NcTokenKind.ExpressionWord || word.Letter != letter)
            {
                continue;
            }

            if (AddedTerm.To(_program.Bytes.Span.Slice(word.ValueStart, word.ValueLength), _program.Syntax, constant) is not { } sum)
            {
                return false;
            }

            Patch(new(word.ValueStart, word.ValueLength, sum));
            return true;
        }

        return false;
    }

    /// <summary>Whether a letter's word itself says that it is a position or an increment.</summary>
    public WordDistance Distance(byte letter) => PlaceOf(letter) is >= 0 and var place ? _words[place].Distance : WordDistance.Modal;

    /// <summary>Gives a letter a new value: changes its word, or inserts one. Keeps the spelling of a word that already has the
    /// value.</summary>
    public void Set(byte letter, NcNumber value)
    {
        var place = PlaceOf(letter);
        if (place < 0)
        {
            Insert(letter, value);
            return;
        }

        ref readonly var token = ref _words[place];
        if (!ValueOf(token).SameValue(value))
        {
            Span<byte> text = stackalloc byte[NumberStyle.LongestText];
            Patch(new(token.ValueStart, token.ValueLength, _text.Keep(text[..Format(token, value, text)])));
        }
    }

    /// <summary>Replaces a letter's word with two others.</summary>
    public void Replace(byte letter, (byte Letter, NcNumber Value) first, (byte Letter, NcNumber Value) second)
    {
        var token = _words[PlaceOf(letter)];
        Span<byte> text = stackalloc byte[2 * (NumberStyle.LongestText + 2)];
        var length = Spell(first.Letter, text);
        length += Format(token, first.Value, text[length..]);
        if (_spaced)
        {
            text[length++] = (byte)' ';
        }

        length += Spell(second.Letter, text[length..]);
        length += Format(token, second.Value, text[length..]);
        Patch(new(token.Start, token.Length, _text.Keep(text[..length])));
    }

    private NcNumber ValueOf(in NcToken token) => CountsIncrements(token) ? new(token.Number.Digits, _incrementDecimals) : token.Number;

    private bool CountsIncrements(in NcToken token) =>
        _incrementDecimals >= 0
            && token.Number.Decimals == 0
            && !_program.Bytes.Span.Slice(token.ValueStart, token.ValueLength).Contains((byte)'.');

    // A number that counts increments stays one if it can; otherwise it gets a point.
    private int Format(in NcToken like, NcNumber value, Span<byte> text)
    {
        var style = NumberStyle.Of(_program.Bytes.Span.Slice(like.ValueStart, like.ValueLength), _programIsFixed);
        style = style.FixedDecimals > 0 ? style : style with { FixedDecimals = -1 };

        // A negative number does not show whether positive ones have a sign; languages write it.
        style = style with { Plus = style.Plus || (_keywordsLead && like.Number.Digits < 0) };
        if (CountsIncrements(like))
        {
            var trimmed = value.Trim();
            if (trimmed.Decimals <= _incrementDecimals)
            {
                return style.Write(new(trimmed.WithDecimals(_incrementDecimals).Digits, 0), text);
            }

            style = style with { Point = true };
        }

        return style.Write(value, text);
    }

    private int PlaceOf(byte letter) => (uint)(letter - 'A') < (uint)_placeOf.Length ? _placeOf[letter - 'A'] - 1 : -1;

    private void Patch(NcPatch patch)
    {
        _isSorted &= _patches.Count == 0 || _patches[^1].Start < patch.Start;
        _patches.Add(patch);
    }

    private int Spell(byte letter, Span<byte> text)
    {
        text[0] = (byte)(_lowerCase ? letter | 0x20 : letter);
        return 1;
    }

    // Inserts after the block number, the codes and the axes that customarily come first (X Y Z, then I J K, then R).
    private void Insert(byte letter, NcNumber value)
    {
        var order = Order(letter);
        var (behind, like) = (-1, -1);
        for (var i = 0; i < _wordCount; i++)
        {
            behind = Order(_words[i].Letter) < order ? i : behind;
            like = like < 0 && _words[i].Kind == NcTokenKind.Word && Order(_words[i].Letter) is >= 1 and <= 7 ? i : like;
        }

        Span<byte> text = stackalloc byte[NumberStyle.LongestText + 3];
        var length = 0;
        if (_spaced && behind >= 0)
        {
            text[length++] = (byte)' ';
        }

        length += Spell(letter, text[length..]);
        length += like >= 0
            ? Format(_words[like], value, text[length..])
            : new NumberStyle(_keywordsLead, Point: !_keywordsLead, LeadingZero: true, FixedDecimals: -1, WholeDigits: 1)
                .Write(value, text[length..]);
        if (_spaced && behind < 0)
        {
            text[length++] = (byte)' ';
        }

        Patch(new(behind >= 0 ? _words[behind].End : _words[0].Start, 0, _text.Keep(text[..length])));
    }

    private static int Order(byte letter) => letter switch
    {
        0 or (byte)'N' or (byte)'G' or (byte)'O' => 0,
        (byte)'X' => 1,
        (byte)'Y' => 2,
        (byte)'Z' => 3,
        (byte)'I' => 4,
        (byte)'J' => 5,
        (byte)'K' => 6,
        (byte)'R' or NcAddress.CircleRadius => 7,
        _ => 8,
    };
}

/// <summary>Stores the new texts of many patches in few memory blocks.</summary>
internal sealed class PatchText
{
    private const int PieceSize = 1 << 16;

    private byte[] _piece = [];
    private int _used;

    /// <summary>Copies a text and returns the stored copy.</summary>
    public ReadOnlyMemory<byte> Keep(ReadOnlySpan<byte> text)
    {
        if (_used + text.Length > _piece.Length)
        {
            (_piece, _used) = (new byte[Math.Max(PieceSize, text.Length)], 0);
        }

        text.CopyTo(_piece.AsSpan(_used));
        _used += text.Length;
        return _piece.AsMemory(_used - text.Length, text.Length);
    }
}
