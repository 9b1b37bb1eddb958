using System.Text;
using ErrorMatching.Refusals;

namespace ErrorMatching.Measurement;

/// <summary>A format that the content of a file shows, with its unit and names, so that no job has to describe it.</summary>
/// <remarks>Each is a subfolder with a class derived from this one, which is registered in <see cref="All"/>.</remarks>
internal abstract class SelfDescribingFormat
{
    /// <summary>Maximum number of points.</summary>
    public const int MaxPoints = 1_000_000;

    private const int HeadBytes = 16_384;

    private static readonly SelfDescribingFormat[] All =
    [
        new QifFormat(), new AqdefFormat(), new DmisFormat(), new CalypsoFormat(), new PcDmisFormat(), new ResultsFileFormat(),
        new ProbingLogFormat(), new RenishawFormat(), new SiemensFormat(), new GrblFormat(), new ProbeOpenFormat(), new DprntFormat(),
    ];

    /// <summary>The format that a file shows; null if it is a table that a job must describe.</summary>
    /// <exception cref="InputException">It is evidently no measurement.</exception>
    public static SelfDescribingFormat? Of(MeasurementBytes source)
    {
        var bytes = source.Bytes.Span[..Math.Min(source.Bytes.Length, HeadBytes)];
        var head = bytes switch
        {
            [0xFF, 0xFE, ..] => Encoding.Unicode.GetString(bytes[2..]),
            [0xFE, 0xFF, ..] => Encoding.BigEndianUnicode.GetString(bytes[2..]),
            [0xEF, 0xBB, 0xBF, ..] => Encoding.Latin1.GetString(bytes[3..]),
            _ => Encoding.Latin1.GetString(bytes),
        };
        var format = Array.Find(All, f => f.Recognizes(source, head));
        if (format is null)
        {
            NoMeasurement.ThrowIf(source, head);
        }

        return format;
    }

    /// <summary>True if a file has this format.</summary>
    /// <param name="source">The file.</param>
    /// <param name="head">Its first characters; only ASCII characters are reliable.</param>
    public abstract bool Recognizes(MeasurementBytes source, string head);

    /// <summary>Reads a file that has this format.</summary>
    /// <param name="source">The file.</param>
    /// <param name="format">The job's format: its encoding for text that is no UTF-8, and its unit for files that name none.</param>
    /// <exception cref="InputException">The content violates the format.</exception>
    public abstract MeasuredContent Read(MeasurementBytes source, MeasurementFormat format);

    /// <summary>The first line that is not blank, without spaces around it.</summary>
    protected static ReadOnlySpan<char> FirstLine(string head)
    {
        var start = head.AsSpan().TrimStart();
        var end = start.IndexOfAny('\r', '\n');
        return (end < 0 ? start : start[..end]).TrimEnd();
    }
}
