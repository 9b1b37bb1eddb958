using System.Buffers;
using System.Text;

namespace ErrorMatching.Nc;

/// <summary>The comment in a compensated program that names its sources: the SHA-256 of the measurement and of the base program. It
/// prevents applying a correction twice.</summary>
/// <param name="MeasurementSha256">SHA-256 of the measurement that was compensated, 64 hexadecimal digits.</param>
/// <param name="BaseSha256">SHA-256 of the program that was displaced, or of the nominal surface for which a new program was made.</param>
public sealed record Marker(string MeasurementSha256, string BaseSha256)
{
    private const string Word = "ERRORMATCH";
    private const string Measurement = "MEASUREMENT=";
    private const string Base = "BASE=";
    private static readonly SearchValues<char> HexDigits = SearchValues.Create("0123456789abcdefABCDEF");

    /// <summary>Code of the refusal of a program that is not the nominal one.</summary>
    public const string AlreadyCompensated = "already-compensated";

    /// <summary>Code of the refusal of a measurement that the program already compensates.</summary>
    public const string SameMeasurement = "same-measurement";

    /// <summary>Code of the refusal of a damaged marker: it is unknown which measurements the program already compensates.</summary>
    public const string MarkerDamaged = "marker-damaged";

    /// <summary>The comment, as a line of a program without its line end.</summary>
    /// <param name="syntax">Syntax of the program: not every control has comments in parentheses.</param>
    public string TextIn(NcSyntax syntax)
    {
        var text = $"{Word} {Measurement}{MeasurementSha256.ToUpperInvariant()} {Base}{BaseSha256.ToUpperInvariant()}";
        return LanguageSpelling.Of(syntax)?.CommentLine(text) ?? (syntax == NcSyntax.Siemens ? $"; {text}" : $"({text})");
    }

    /// <summary>All markers of a program with the positions of their blocks; null for a marker whose hashes are too damaged to
    /// read.</summary>
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
                // A comment without its end is not a comment for the tokenizer, but it can still be a marker.
                if (token.Kind is NcTokenKind.Comment or NcTokenKind.Invalid
                    && IsMarker(Encoding.Latin1.GetString(program.Bytes.Span.Slice(token.Start, token.Length)), out var marker))
                {
                    found.Add((i, marker));
                }
            }
        }

        return found;
    }

    /// <summary>The program with the marker as a separate line. If it begins with the percent sign and the program number, the marker
    /// comes after them, so that the control still finds both.</summary>
    public byte[] InsertInto(NcProgram program)
    {
        ArgumentNullException.ThrowIfNull(program);

        // A byte order mark is valid only at the very beginning, so the first line stays first.
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

    // The blocks up to the percent sign and the program number, or up to the statement that begins the program, including empty ones
    // before and between them.
    private static int HeadLength(NcProgram program)
    {
        var length = 0;
        var language = LanguageSpelling.Of(program.Syntax);
        for (var i = 0; i < program.BlockCount; i++)
        {
            // In ISO programs, a colon can replace the letter O.
            var names = program.BytesOf(program[i]) is [(byte)':', ..];
            foreach (var token in program.Tokens(program[i]))
            {
                if (token.Kind is NcTokenKind.Percent || token is { Kind: NcTokenKind.Word, Letter: (byte)'O' }
                    || (token.Kind is NcTokenKind.Keyword or NcTokenKind.Label
                        && language?.IsHeading(program.Bytes.Span.Slice(token.Start, token.Length)) == true))
                {
                    names = true;
                }
                else if (!names && token.Kind is not (NcTokenKind.Space or NcTokenKind.Comment)
                    && (language is null || token.Letter != 'N'))
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
