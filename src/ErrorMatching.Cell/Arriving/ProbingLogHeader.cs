using System.Text;
using ErrorMatching.Measurement;

namespace ErrorMatching.Cell;

/// <summary>What the log of a probing program tells about its piece: the plan number in its first line, and comments from the shop's
/// template, such as <c>; SERIAL: 4711</c>.</summary>
internal static class ProbingLogHeader
{
    /// <summary>Name of the field with the plan's number.</summary>
    public const string Plan = "PLAN";

    private const int MostLines = 200;
    private const int MostLength = 200;
    private static readonly string[] FirstWords = ["ERRORMATCH", "PROBE", "PLAN"];

    /// <summary>The fields of the log's first lines.</summary>
    public static IReadOnlyList<HeaderField> Read(ReadOnlySpan<byte> bytes)
    {
        var fields = new List<HeaderField>();
        for (var line = 1; line <= MostLines && bytes.Length > 0; line++)
        {
            var end = bytes.IndexOfAny("\r\n"u8);
            var text = bytes[..(end < 0 ? bytes.Length : end)];
            bytes = bytes[Math.Min(bytes.Length, text.Length + (bytes[text.Length..].StartsWith("\r\n"u8) ? 2 : 1))..];
            if (text.Length <= MostLength)
            {
                Add(fields, Encoding.Latin1.GetString(text).Trim(), line);
            }
        }

        return fields;
    }

    private static void Add(List<HeaderField> fields, string line, int number)
    {
        if (line.Split(' ', StringSplitOptions.RemoveEmptyEntries) is [var first, var second, var third, var plan, ..]
            && FirstWords.SequenceEqual([first, second, third]))
        {
            fields.Add(new(Plan, plan, number));
        }
        else if (line.Length > 0 && line[0] is ';' or '%' && line.IndexOfAny([':', '=']) is var at and > 0)
        {
            fields.Add(new(line[1..at].Trim(), line[(at + 1)..].Trim(), number));
        }
    }
}
