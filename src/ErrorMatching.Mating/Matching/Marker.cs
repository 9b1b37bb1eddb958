using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>
/// The comment by which a compensated program tells what it was made of: the SHA-256 of the measurement and of the base program. It keeps a correction from being applied twice.
/// </summary>
/// <param name="MeasurementSha256">SHA-256 of the measurement that was compensated, 64 hexadecimal digits.</param>
/// <param name="BaseSha256">SHA-256 of the program that was displaced.</param>
public sealed record Marker(string MeasurementSha256, string BaseSha256)
{
    private const string Word = "ERRORMATCH";
    private const string Measurement = "MEASUREMENT=";
    private const string Base = "BASE=";

    /// <summary>Code of the refusal of a program that is not the nominal one.</summary>
    public const string AlreadyCompensated = "already-compensated";

    /// <summary>Code of the refusal of a measurement that the program already follows.</summary>
    public const string SameMeasurement = "same-measurement";

    /// <summary>The comment, as a line of the program without its line end.</summary>
    public string Text => $"({Word} {Measurement}{MeasurementSha256.ToUpperInvariant()} {Base}{BaseSha256.ToUpperInvariant()})";

    /// <summary>All markers of a program with the positions of their blocks.</summary>
    public static IReadOnlyList<(int Block, Marker Marker)> Find(NcProgram program)
    {
        var found = new List<(int, Marker)>();
        var span = program.Bytes.Span;
        if (span.IndexOf(Encoding.ASCII.GetBytes(Word)) < 0)
        {
            return found;
        }

        for (var i = 0; i < program.BlockCount; i++)
        {
            foreach (var token in program.Tokens(program[i]))
            {
                if (token.Kind == NcTokenKind.Comment && Parse(Encoding.Latin1.GetString(span.Slice(token.Start, token.Length))) is { } marker)
                {
                    found.Add((i, marker));
                }
            }
        }

        return found;
    }

    /// <summary>
    /// The program with the marker as a line of its own: behind the percent sign and the program number if it begins with them, so that the control still finds both.
    /// </summary>
    public byte[] InsertInto(NcProgram program)
    {
        var at = 0;
        while (at < program.BlockCount && IsHead(program, program[at]))
        {
            at++;
        }

        var start = at < program.BlockCount ? program[at].Start : program.Bytes.Length;
        var lineEnd = LineEnd(program);
        byte[] line = [.. Encoding.ASCII.GetBytes(Text), .. lineEnd];
        var headHasEnd = at == 0 || program[at - 1].FullLength > program[at - 1].Length;
        return NcPatch.Apply(program.Bytes.Span, [new(start, 0, headHasEnd ? line : (byte[])[.. lineEnd, .. Encoding.ASCII.GetBytes(Text)])]);
    }

    private static Marker? Parse(string comment)
    {
        var words = comment.Trim('(', ')', ';', ' ').Split(' ', StringSplitOptions.RemoveEmptyEntries);
        return words is [Word, var measurement, var program]
            && measurement.StartsWith(Measurement, StringComparison.Ordinal) && program.StartsWith(Base, StringComparison.Ordinal)
            ? new(measurement[Measurement.Length..].ToLowerInvariant(), program[Base.Length..].ToLowerInvariant())
            : null;
    }

    // Percent sign, program number, and what is empty between them.
    private static bool IsHead(NcProgram program, NcBlock block)
    {
        foreach (var token in program.Tokens(block))
        {
            if (token.Kind is not (NcTokenKind.Space or NcTokenKind.Percent or NcTokenKind.Comment) && token is not { Kind: NcTokenKind.Word, Letter: (byte)'O' or (byte)':' })
            {
                return false;
            }
        }

        foreach (var token in program.Tokens(block))
        {
            if (token.Kind is NcTokenKind.Percent or NcTokenKind.Word)
            {
                return true;
            }
        }

        return false;
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
