using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>A program as it is: its bytes and the starts of its blocks. Nothing is decoded, normalized or dropped, so the bytes are
/// always complete.</summary>
/// <remarks>Line ends are CR LF, LF or CR, also mixed. Blocks are tokenized on access; memory is the file plus 4 bytes per block.</remarks>
public sealed class NcProgram
{
    /// <summary>Maximum size of a program, in bytes.</summary>
    public const int MaxBytes = 1 << 30;

    /// <summary>Minimum number of bytes for a second thread to pay off.</summary>
    internal const int Many = 4_000_000;

    private readonly int[] _starts;
    private readonly int _count;

    private NcProgram(ReadOnlyMemory<byte> bytes, int[] starts, int count, NcSyntax syntax)
    {
        Bytes = bytes;
        Syntax = syntax;
        _starts = starts;
        _count = count;
    }

    /// <summary>The program's bytes.</summary>
    public ReadOnlyMemory<byte> Bytes { get; }

    /// <summary>Its syntax.</summary>
    public NcSyntax Syntax { get; }

    /// <summary>Number of blocks (lines). A line end at the very end of the file does not begin another block.</summary>
    public int BlockCount => _count;

    /// <summary>The block at a position, from 0.</summary>
    public NcBlock this[int index]
    {
        get
        {
            ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual((uint)index, (uint)_count, nameof(index));
            var start = _starts[index];
            var next = index + 1 < _count ? _starts[index + 1] : Bytes.Length;
            var span = Bytes.Span;
            var end = next;
            if (end > start && span[end - 1] == (byte)'\n')
            {
                end--;
            }

            if (end > start && span[end - 1] == (byte)'\r')
            {
                end--;
            }

            return new(index, start, end - start, next - start);
        }
    }

    /// <summary>The block that contains a byte.</summary>
    internal int BlockAt(int position)
    {
        var at = Array.BinarySearch(_starts, 0, _count, position);
        return at >= 0 ? at : ~at - 1;
    }

    /// <summary>Finds the blocks of a program. The bytes are not copied: do not change them afterwards.</summary>
    /// <param name="bytes">The program's bytes.</param>
    /// <param name="syntax">Its syntax; <see cref="NcDialect.Syntax"/> of its dialect.</param>
    /// <exception cref="InputException">The program is larger than <see cref="MaxBytes"/>.</exception>
    public static NcProgram Read(ReadOnlyMemory<byte> bytes, NcSyntax syntax = NcSyntax.Iso)
    {
        if (bytes.Length > MaxBytes)
        {
            throw new InputException(
                new Refusal(NcInputCodes.ProgramTooLarge, $"The program has {bytes.Length} bytes; at most {MaxBytes} are read."));
        }

        // The two halves of a long program are searched concurrently; a block begins after any line feed.
        var half = bytes.Length < Many ? -1 : bytes.Span[(bytes.Length / 2)..].IndexOf((byte)'\n');
        if (half < 0)
        {
            var (starts, count) = BlocksOf(bytes, 0, bytes.Length, (bytes.Length / 24) + 1);
            return new(bytes, starts, count, syntax);
        }

        half += (bytes.Length / 2) + 1;
        var behind = Task.Run(() => BlocksOf(bytes, half, bytes.Length, ((bytes.Length - half) / 24) + 1));
        var (all, before) = BlocksOf(bytes, 0, half, (bytes.Length / 24) + 1);
        var (others, more) = behind.GetAwaiter().GetResult();
        if (before + more > all.Length)
        {
            Array.Resize(ref all, before + more);
        }

        Array.Copy(others, 0, all, before, more);
        return new(bytes, all, before + more, syntax);
    }

    // The starts of the blocks in a range that begins with a block, and their number.
    private static (int[] Starts, int Count) BlocksOf(ReadOnlyMemory<byte> bytes, int position, int end, int expected)
    {
        var span = bytes.Span[..end];
        var starts = new int[Math.Max(16, expected)];
        var count = 0;
        while (position < span.Length)
        {
            if (count == starts.Length)
            {
                Array.Resize(ref starts, starts.Length * 2);
            }

            starts[count++] = position;
            var length = span[position..].IndexOfAny((byte)'\n', (byte)'\r');
            if (length < 0)
            {
                break;
            }

            position += length;
            position += span[position] == (byte)'\r' && position + 1 < span.Length && span[position + 1] == (byte)'\n' ? 2 : 1;
        }

        return (starts, count);
    }

    /// <summary>The same bytes in another syntax; the starts of blocks do not depend on it.</summary>
    public NcProgram In(NcSyntax syntax) => syntax == Syntax ? this : new(Bytes, _starts, _count, syntax);

    /// <summary>Creates a program from text, for tests and examples. The text is encoded as UTF-8 without a byte order mark.</summary>
    public static NcProgram FromText(string text, NcSyntax syntax = NcSyntax.Iso) => Read(Encoding.UTF8.GetBytes(text), syntax);

    /// <summary>The block's bytes without its line end.</summary>
    public ReadOnlySpan<byte> BytesOf(NcBlock block) => Bytes.Span.Slice(block.Start, block.Length);

    /// <summary>The block's text without its line end and the file's byte order mark, for people and patterns: UTF-8 if valid, otherwise
    /// Latin-1.</summary>
    public string TextOf(NcBlock block) => NcText.Decode(BytesOf(block)[(block.Start == 0 ? SyntaxBytes.MarkLength(BytesOf(block)) : 0)..]);

    /// <summary>The tokens of a block, in order, without gaps.</summary>
    public NcTokenizer Tokens(NcBlock block) => new(Bytes.Span, block.Start, block.End, Syntax);

    /// <summary>The N word of a block as written (<c>N110</c>); an empty text if it has none.</summary>
    public string NumberOf(NcBlock block) =>
        TryNumber(block, out var token) ? NcText.Decode(Bytes.Span.Slice(token.Start, token.Length)) : "";

    /// <summary>The name of a block in messages: its N word if it has one, otherwise its line.</summary>
    public string NameOf(NcBlock block) => NumberOf(block) is { Length: > 0 } number ? number : $"line {block.Line}";

    /// <summary>The value of a block's N word, as found by <see cref="TryNumber"/>.</summary>
    internal bool TryNumberValue(int block, out NcNumber number)
    {
        // Nearly all blocks begin with N and a whole number, then a space and another word: those need neither a tokenizer nor the
        // block's end.
        var bytes = Bytes.Span[_starts[block]..];
        if (bytes.Length > 0 && (bytes[0] | 0x20) == 'n')
        {
            long digits = 0;
            var at = 1;
            for (; at < bytes.Length && at < NcNumber.MaxDigits && SyntaxBytes.IsDigit(bytes[at]); at++)
            {
                digits = (digits * 10) + (bytes[at] - '0');
            }

            if (at > 1 && at + 1 < bytes.Length && bytes[at] == ' ' && SyntaxBytes.IsLetter(bytes[at + 1]))
            {
                number = new(digits, 0);
                return true;
            }
        }

        var found = TryNumber(this[block], out var token);
        number = token.Number;
        return found;
    }

    /// <summary>Finds the N word of a block: its first word, after block skip and comments.</summary>
    public bool TryNumber(NcBlock block, out NcToken token)
    {
        // A block that begins with the letter of another word has none; most blocks of programs without numbers do.
        var bytes = BytesOf(block);
        if (bytes.Length > 0 && SyntaxBytes.IsLetter(bytes[0]) && (bytes[0] | 0x20) != 'n')
        {
            token = default;
            return false;
        }

        foreach (var candidate in Tokens(block))
        {
            if (candidate.Kind is NcTokenKind.Space or NcTokenKind.BlockSkip or NcTokenKind.Comment)
            {
                continue;
            }

            token = candidate;
            return candidate is { Kind: NcTokenKind.Word, Letter: (byte)'N' };
        }

        token = default;
        return false;
    }
}
