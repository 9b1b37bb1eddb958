using System.Text;

namespace ErrorMatching.Nc;

/// <summary>
/// A program as it is: its bytes, and where its blocks begin. Nothing is decoded, normalized or dropped,
/// so the bytes are always the whole truth.
/// </summary>
/// <remarks>Line ends are CR LF, LF or CR, also mixed. Blocks are tokenized when they are looked at;
/// memory is the file and 4 bytes a block.</remarks>
public sealed class NcProgram
{
    /// <summary>Largest program that is read, in bytes.</summary>
    public const int MaxBytes = 1 << 30;

    /// <summary>From so many bytes on, a second core is worth its start.</summary>
    private const int Many = 4_000_000;

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

    /// <summary>How it is spelled.</summary>
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

    /// <summary>The block that a byte belongs to.</summary>
    internal int BlockAt(int position)
    {
        var at = Array.BinarySearch(_starts, 0, _count, position);
        return at >= 0 ? at : ~at - 1;
    }

    /// <summary>Finds the blocks of a program. The bytes are kept, not copied: do not change them afterwards.</summary>
    /// <param name="bytes">The program's bytes.</param>
    /// <param name="syntax">How it is spelled; <see cref="NcDialect.Syntax"/> of its dialect.</param>
    /// <exception cref="NcException">The program is larger than <see cref="MaxBytes"/>.</exception>
    public static NcProgram Read(ReadOnlyMemory<byte> bytes, NcSyntax syntax = NcSyntax.Iso)
    {
        if (bytes.Length > MaxBytes)
        {
            throw new NcException(NcErrorCode.ProgramTooLarge, $"The program has {bytes.Length} bytes; at most {MaxBytes} are read.");
        }

        // A long program is searched in two halves beside each other; behind any line feed a block begins.
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

    // Where the blocks begin between two places, the first of which begins one; and how many they are.
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

    /// <summary>The same bytes in another spelling; where blocks begin does not depend on it.</summary>
    public NcProgram In(NcSyntax syntax) => syntax == Syntax ? this : new(Bytes, _starts, _count, syntax);

    /// <summary>A program from text; for tests and examples. The text is written as UTF-8 without a mark.</summary>
    public static NcProgram FromText(string text, NcSyntax syntax = NcSyntax.Iso) => Read(Encoding.UTF8.GetBytes(text), syntax);

    /// <summary>The block's bytes without its line end.</summary>
    public ReadOnlySpan<byte> BytesOf(NcBlock block) => Bytes.Span.Slice(block.Start, block.Length);

    /// <summary>The block's text without its line end and the file's UTF-8 mark, for people and patterns:
    /// UTF-8 where it is valid, else Latin-1.</summary>
    public string TextOf(NcBlock block) => NcText.Decode(BytesOf(block)[(block.Start == 0 ? SyntaxBytes.MarkLength(BytesOf(block)) : 0)..]);

    /// <summary>The tokens of a block, in order, without gap.</summary>
    public NcTokenizer Tokens(NcBlock block) => new(Bytes.Span, block.Start, block.End, Syntax);

    /// <summary>The N word of a block as written (<c>N110</c>), or an empty text where it has none.</summary>
    public string NumberOf(NcBlock block) =>
        TryNumber(block, out var token) ? NcText.Decode(Bytes.Span.Slice(token.Start, token.Length)) : "";

    /// <summary>How messages name a block: its N word if it has one, else its line.</summary>
    public string NameOf(NcBlock block) => NumberOf(block) is { Length: > 0 } number ? number : $"line {block.Line}";

    /// <summary>The value of a block's N word, as <see cref="TryNumber"/> finds it.</summary>
    internal bool TryNumberValue(int block, out NcNumber number)
    {
        // Nearly all blocks begin with N and a whole number, and then a space and another word:
        // those take no tokenizer, nor where they end.
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

    /// <summary>Finds the N word of a block: its first word, behind block skip and comments.</summary>
    public bool TryNumber(NcBlock block, out NcToken token)
    {
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
