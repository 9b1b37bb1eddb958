using System.Buffers;
using System.Text;

namespace ErrorMatching.Nc;

/// <summary>
/// The comment by which a compensated program tells what it was made of: the SHA-256 of the measurement and of the base program.
/// It keeps a correction from being applied twice.
/// </summary>
/// <param name="MeasurementSha256">SHA-256 of the measurement that was compensated, 64 hexadecimal digits.</param>
/// <param name="BaseSha256">SHA-256 of the program that was displaced, or of the nominal surface for which a program was made anew.</param>
public sealed record Marker(string MeasurementSha256, string BaseSha256)
{
    private const string Word = "ERRORMATCH";
    private const string Measurement = "MEASUREMENT=";
    private const string Base = "BASE=";
    private static readonly SearchValues<char> HexDigits = SearchValues.Create("0123456789abcdefABCDEF");

    /// <summary>Code of the refusal of a program that is not the nominal one.</summary>
    public const string AlreadyCompensated = "already-compensated";

    /// <summary>Code of the refusal of a measurement that the program already follows.</summary>
    public const string SameMeasurement = "same-measurement";

    /// <summary>Code of the refusal of a marker that cannot be read, so that nobody knows which measurements the program already
    /// follows.</summary>
    public const string MarkerDamaged = "marker-damaged";

    /// <summary>The comment, as a line of a program without its line end.</summary>
    /// <param name="syntax">How the program is spelled: Siemens controls have no comments in parentheses.</param>
    public string TextIn(NcSyntax syntax)
    {
        var text = $"{Word} {Measurement}{MeasurementSha256.ToUpperInvariant()} {Base}{BaseSha256.ToUpperInvariant()}";
        return syntax == NcSyntax.Siemens ? $"; {text}" : $"({text})";
    }

    /// <summary>All markers of a program with the positions of their blocks;
    /// a marker that was damaged so that its hashes cannot be read is null.</summary>
    public static IReadOnlyList<(int Block, Marker? Marker)> Find(NcProgram program)
    {
        ArgumentNullException.ThrowIfNull(program);
        var found = new List<(int, Marker?)>();
        if (!HoldsWord(program.Bytes.Span))
        {
            return found;
        }

        for (var i = 0; i < program.BlockCount; i++)
        {
            foreach (var token in program.Tokens(program[i]))
            {
                // A comment that lost its end is no comment for the tokenizer, but it is a marker for us.
                if (token.Kind is NcTokenKind.Comment or NcTokenKind.Invalid
                    && IsMarker(Encoding.Latin1.GetString(program.Bytes.Span.Slice(token.Start, token.Length)), out var marker))
                {
                    found.Add((i, marker));
                }
            }
        }

        return found;
    }

    /// <summary>
    /// The program with the marker as a line of its own: behind the percent sign and the program number if it begins with them,
    /// so that the control still finds both.
    /// </summary>
    public byte[] InsertInto(NcProgram program)
    {
        ArgumentNullException.ThrowIfNull(program);

        // A UTF-8 mark is one only at the very beginning, so what comes first stays first.
        var at = Math.Max(HeadLength(program), program.Bytes.Span.StartsWith("\uFEFF"u8) ? 1 : 0);
        var start = at < program.BlockCount ? program[at].Start : program.Bytes.Length;
        var lineEnd = LineEnd(program);
        var text = Encoding.ASCII.GetBytes(TextIn(program.Syntax));
        byte[] line = [.. text, .. lineEnd];
        var headHasEnd = at == 0 || program[at - 1].FullLength > program[at - 1].Length;
        return NcPatch.Apply(program.Bytes.Span, [new(start, 0, headHasEnd ? line : (byte[])[.. lineEnd, .. text])]);
    }

    private static bool HoldsWord(ReadOnlySpan<byte> bytes)
    {
        while (bytes.IndexOfAny((byte)Word[0], (byte)(Word[0] | 0x20)) is >= 0 and var at)
        {
            bytes = bytes[at..];
            if (bytes.Length >= Word.Length && Ascii.EqualsIgnoreCase(bytes[..Word.Length], Word))
            {
                return true;
            }

            bytes = bytes[1..];
        }

        return false;
    }

    private static bool IsMarker(string comment, out Marker? marker)
    {
        var words = comment.Trim('(', ')', ';', ' ').Split(' ', StringSplitOptions.RemoveEmptyEntries);
        marker = words is [_, var measurement, var program]
            && HashBehind(Measurement, measurement) is { } m
            && HashBehind(Base, program) is { } b
            ? new(m, b)
            : null;
        return words.Length > 0 && words[0].Equals(Word, StringComparison.OrdinalIgnoreCase);
    }

    private static string? HashBehind(string name, string word)
    {
        const int digits = 64;
        return word.Length == name.Length + digits
            && word.StartsWith(name, StringComparison.OrdinalIgnoreCase)
            && word.AsSpan(name.Length).IndexOfAnyExcept(HexDigits) < 0
            ? word[name.Length..].ToLowerInvariant()
            : null;
    }

    // The blocks up to the percent sign and the program number, with what is empty before and between them.
    private static int HeadLength(NcProgram program)
    {
        var length = 0;
        for (var i = 0; i < program.BlockCount; i++)
        {
            // A colon is the letter O in programs of ISO code.
            var names = program.BytesOf(program[i]) is [(byte)':', ..];
            foreach (var token in program.Tokens(program[i]))
            {
                if (token.Kind is NcTokenKind.Percent || token is { Kind: NcTokenKind.Word, Letter: (byte)'O' })
                {
                    names = true;
                }
                else if (!names && token.Kind is not (NcTokenKind.Space or NcTokenKind.Comment))
                {
                    return length;
                }
            }

            length = names ? i + 1 : length;
        }

        return length;
    }

    private static byte[] LineEnd(NcProgram program)
    {
        if (program.BlockCount == 0 || program[0].FullLength == program[0].Length)
        {
            return "\n"u8.ToArray();
        }

        var first = program[0];
        return program.Bytes.Span[first.End..(first.Start + first.FullLength)].ToArray();
    }
}
