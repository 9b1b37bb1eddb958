using System.Buffers.Binary;
using System.Text.RegularExpressions;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>Recognizes files that are often given instead of a measurement.</summary>
internal static partial class NoMeasurement
{
    private const string Export = "text: export the points as a table, or as QIF, AQDEF or DMIS";

    private static readonly (Func<MeasurementBytes, string, bool> Is, string Found, string Expected)[] Kinds =
    [
        ((_, head) => head.StartsWith("ISO-10303-21", StringComparison.Ordinal), "a STEP file", FileOf("a surface")),
        ((_, head) => IgesStart().IsMatch(head), "an IGES file", FileOf("a surface")),
        (IsMesh, "a mesh of triangles (STL)", "the gauge's points: export them as a table, or as QIF, AQDEF or DMIS"),
        ((_, head) => head is ['{', ..] && head.Contains('"'), "a JSON document, such as a job or a report", FileOf("a job")),
        ((_, head) => Program().IsMatch(head), "an NC program", FileOf("a program")),
        ((_, head) => head.StartsWith("%PDF", StringComparison.Ordinal), "a PDF", Export),
        ((_, head) => Html().IsMatch(head), "an HTML page", Export),
        ((_, head) => head.StartsWith("<?xml", StringComparison.Ordinal), "an XML document that is not QIF", "QIF 3.0 results"),
    ];

    /// <summary>Throws if a file is evidently something else than a measurement.</summary>
    /// <param name="source">The file.</param>
    /// <param name="head">Its first characters; only ASCII characters are reliable.</param>
    /// <exception cref="InputException"><see cref="MeasurementError.NotAMeasurement"/>.</exception>
    public static void ThrowIf(MeasurementBytes source, string head)
    {
        var start = head.TrimStart();
        var kind = Array.Find(Kinds, k => k.Is(source, start));
        if (kind.Is is not null)
        {
            throw Place.Start(source.File).Fail(MeasurementError.NotAMeasurement, kind.Found, kind.Expected);
        }
    }

    /// <summary>True if a file begins as an NC program does.</summary>
    /// <param name="head">Its first characters.</param>
    public static bool IsProgram(string head) => Program().IsMatch(head.TrimStart());

    private static string FileOf(string other) => $"the measured points of a piece: this is the file of {other}, name the gauge's file";

    private static bool IsMesh(MeasurementBytes source, string head)
    {
        const int header = 80, facet = 50;
        var bytes = source.Bytes.Span;
        return (head.StartsWith("solid", StringComparison.Ordinal) && head.Contains("facet", StringComparison.Ordinal))
            || (bytes.Length > header + 4
                && BinaryPrimitives.ReadUInt32LittleEndian(bytes[header..]) is > 0 and var count
                && bytes.Length == header + 4 + ((long)count * facet));
    }

    [GeneratedRegex(@"\A[^\n]{72}S {0,6}0{0,6}1\s", RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex IgesStart();

    // The first lines of a program: a percent sign, a number, a comment or a block, then a block with a G word.
    [GeneratedRegex(
        @"\A(%|[O:][0-9]+|N[0-9]+|\(|;|G[0-9]+)[^\n,;]*\n([^\n]*\n){0,30}?[ \t]*(N[0-9]+[ \t]*)?G[0-9]{1,3}\b",
        RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex Program();

    [GeneratedRegex(
        @"\A<(!doctype )?html\b", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Html();
}
