namespace ErrorMatching.Nc;

/// <content>
/// Reads a block in one pass over its bytes if it has plain words only, as nearly all blocks do; otherwise by its tokens. Both give the
/// same words, as a test checks.
/// </content>
internal sealed partial class BlockWords
{
    private static readonly System.Buffers.SearchValues<byte> ZeroBytes = System.Buffers.SearchValues.Create("+-0. \t"u8);

    private static ReadOnlySpan<double> Powers => [1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

    /// <summary>Reads a block of plain words in one pass; false if it has anything else.</summary>
    public bool TryReadPlain(ReadOnlySpan<byte> text, ControlWays ways)
    {
        Clear();
        return ways.HasCodes && ReadPlain(text, ways.SpacesInNumbers);
    }

    /// <summary>Reads letters with numbers, and spaces between them. False for anything else.</summary>
    private bool ReadPlain(ReadOnlySpan<byte> text, bool spacesInNumbers)
    {
        var (at, words) = (0, 0);
        var (present, repeated, integers) = (0u, 0u, 0u);
        while (true)
        {
            while ((uint)at < (uint)text.Length && text[at] == ' ')
            {
                at++;
            }

            if ((uint)at >= (uint)text.Length)
            {
                (Present, Repeated, Integers, Count) = (present, repeated, integers, words);
                return true;
            }

            var letter = (text[at++] | 0x20) - 'a';
            while ((uint)at < (uint)text.Length && text[at] == ' ')
            {
                at++;
            }

            if ((uint)letter >= 26 || (uint)at >= (uint)text.Length)
            {
                return false;
            }

            var negative = text[at] == '-';
            at += negative || text[at] == '+' ? 1 : 0;
            var first = at;
            long digits = 0;
            uint digit;
            while ((uint)at < (uint)text.Length && (digit = (uint)text[at] - '0') < 10)
            {
                digits = (digits * 10) + digit;
                at++;
            }

            var (count, decimals) = (at - first, -1);
            if ((uint)at < (uint)text.Length && text[at] == '.')
            {
                first = ++at;
                while ((uint)at < (uint)text.Length && (digit = (uint)text[at] - '0') < 10)
                {
                    digits = (digits * 10) + digit;
                    at++;
                }

                decimals = at - first;
                count += decimals;
            }

            if ((uint)(count - 1) >= NcNumber.ExactDigits || (spacesInNumbers && at < text.Length && text[at] == ' ' && GoesOn(text[at..])))
            {
                return false;
            }

            words++;
            digits = negative ? -digits : digits;
            switch (letter)
            {
                case 'G' - 'A':
                    AddCode(digits, Math.Max(0, decimals));
                    break;
                case 'M' - 'A':
                    AddFunction(digits, Math.Max(0, decimals));
                    break;
                default:
                    // A block number behind another word counts as a second one.
                    var bit = 1u << letter;
                    repeated |= letter == 'N' - 'A' && words > 1 ? bit : present & bit;
                    present |= bit;
                    integers |= decimals < 0 ? bit : 0;
                    _values[letter] = decimals > 0 ? digits / Powers[decimals] : digits;
                    break;
            }
        }
    }

    private static bool GoesOn(ReadOnlySpan<byte> text) =>
        text.TrimStart((byte)' ') is { Length: > 0 } rest && (rest[0] == '.' || SyntaxBytes.IsDigit(rest[0]));

    /// <summary>Reads any block by its tokens.</summary>
    /// <param name="bytes">The program's bytes.</param>
    /// <param name="start">Start of the block's words.</param>
    /// <param name="end">End of the block.</param>
    /// <param name="syntax">Its syntax.</param>
    /// <param name="compute">Returns the value of a computed word: NaN if only the machine knows it, null if it is a variable that was
    /// never set.</param>
    public void ReadTokens(ReadOnlySpan<byte> bytes, int start, int end, NcSyntax syntax, Func<NcToken, double?> compute)
    {
        Clear();
        _arePlain = false;
        foreach (var token in new NcTokenizer(bytes, start, end, syntax))
        {
            switch (token.Kind)
            {
                case NcTokenKind.Word when token.Letter == 'G':
                    AddCode(token.Number.Digits, token.Number.Decimals);
                    break;
                case NcTokenKind.Word when token.Letter == 'M':
                    AddFunction(token.Number.Digits, token.Number.Decimals);
                    break;
                case NcTokenKind.Word:
                    Repeated |= token.Letter == 'N' && HasWords() ? Bit('N') : 0;
                    AddNumber(
                        token.Letter - 'A', token.Number.Value, !bytes.Slice(token.ValueStart, token.ValueLength).Contains((byte)'.'));
                    AddDistance(token);
                    break;
                case NcTokenKind.ExpressionWord:
                    AddComputed(token, compute(token));
                    AddDistance(token);
                    break;
                case NcTokenKind.CommaWord:
                    Corner = token.Letter;
                    CornerIsInteger = !bytes.Slice(token.ValueStart, token.ValueLength).Contains((byte)'.');
                    CornerValue = ValueOf(bytes, token, compute);
                    break;
                case NcTokenKind.PolarWord when token.Letter == '@':
                    PolarDistance = ValueOf(bytes, token, compute);
                    PolarDistanceGrows = token.Distance == WordDistance.Incremental;
                    break;
                case NcTokenKind.PolarWord:
                    PolarAngle = ValueOf(bytes, token, compute);
                    PolarAngleGrows = token.Distance == WordDistance.Incremental;
                    break;
                case NcTokenKind.Keyword or NcTokenKind.Assignment or NcTokenKind.Expression:
                    AddStatement(token);
                    break;
                case NcTokenKind.Comment when bytes[token.Start] == ';':
                    Semicolon = token;
                    break;
                case NcTokenKind.Invalid when Invalid.Length == 0:
                    Invalid = token;
                    break;
            }
        }
    }

    private bool HasWords() => (Present | Computed) != 0 || _codeCount + _functionCount + _statementCount > 0;

    private static double ValueOf(ReadOnlySpan<byte> bytes, NcToken token, Func<NcToken, double?> compute) =>
        token.Number == default && !IsZero(bytes, token) ? compute(token) ?? double.NaN : token.Number.Value;

    // A word of a plain zero; a computed word has no number either.
    private static bool IsZero(ReadOnlySpan<byte> bytes, NcToken token) =>
        !bytes.Slice(token.ValueStart, token.ValueLength).ContainsAnyExcept(ZeroBytes);

    private void AddDistance(NcToken token)
    {
        Absolute |= token.Distance == WordDistance.Absolute ? Bit(token.Letter) : 0;
        Incremental |= token.Distance == WordDistance.Incremental ? Bit(token.Letter) : 0;
    }

    // NaN is a value that only the machine knows. Null was never set: the word counts as not written.
    private void AddComputed(NcToken token, double? value)
    {
        if (value is not { } number)
        {
            return;
        }

        if (token.Letter is (byte)'G' or (byte)'M')
        {
            var tenths = Math.Round(number * 10);
            if (token.Letter == 'G' && tenths is >= 0 and < 10_000)
            {
                AddCode((long)tenths, 1);
            }
            else if (token.Letter == 'M' && tenths is >= 0 and < 1e7)
            {
                AddFunction((long)tenths, 1);
            }

            Computed |= Bit(token.Letter);
            Unknown |= double.IsNaN(number) ? Bit(token.Letter) : 0;
            return;
        }

        var bit = Bit(token.Letter);
        Repeated |= (Present | Computed) & bit;
        Computed |= bit;
        if (double.IsNaN(number))
        {
            Unknown |= bit;
        }
        else
        {
            Present |= bit;
            _values[token.Letter - 'A'] = number + 0.0;
        }
    }
}
