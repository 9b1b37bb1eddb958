using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Writes drafts as the files of a job, and reads them back without loss.</summary>
public static class MatingDraftFiles
{
    /// <summary>The job's file.</summary>
    public static byte[] Job(MatingDraft draft) => new DraftWriter(draft).Job();

    /// <summary>The theoretical points' file: <c>point,x_mm,y_mm</c>, and <c>z_mm</c> if a point has one.</summary>
    public static byte[] Theoretical(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        return Theoretical([.. draft.Points]);
    }

    /// <summary>Opens a job for editing.</summary>
    /// <param name="file">The job's file.</param>
    /// <exception cref="InputException">A file cannot be opened. The job cannot be used. The theoretical points cannot be
    /// used.</exception>
    /// <exception cref="DraftException">The job contains something that a draft cannot represent and would lose.</exception>
    public static MatingDraft Open(string file)
    {
        var bytes = InputFile.Open(file, p => JsonInput.Load(p));
        var job = MatingJob.Parse(bytes, file);
        return Read(bytes, file, InputFile.Bytes(job.PathOf(job.Part.Theoretical), MeasurementFormat.Points.MaxBytes));
    }

    /// <summary>Creates a draft from a job's files.</summary>
    /// <param name="bytes">The job's file, which must be usable.</param>
    /// <param name="file">Its name.</param>
    /// <param name="theoretical">The theoretical points' file.</param>
    /// <exception cref="InputException">The theoretical points cannot be used.</exception>
    /// <exception cref="DraftException">The job contains something that a draft cannot represent and would lose.</exception>
    public static MatingDraft Read(ReadOnlySpan<byte> bytes, string file, ReadOnlyMemory<byte> theoretical)
    {
        var end = theoretical.Span.IndexOfAny((byte)'\r', (byte)'\n');
        var header = Encoding.UTF8.GetString(theoretical.Span[..(end < 0 ? theoretical.Length : end)]).TrimStart('\uFEFF');
        var root = JsonInput.Read(bytes, file);
        return new DraftReader(
            root, file, MeasurementReader.Read(theoretical, root["part"]["theoretical"].Text, MeasurementFormat.Points), header).Read();
    }

    /// <summary>True if the job's file has comments, which a draft does not preserve.</summary>
    public static bool HasComments(ReadOnlySpan<byte> bytes)
    {
        var reader = new System.Text.Json.Utf8JsonReader(
            bytes, new() { CommentHandling = System.Text.Json.JsonCommentHandling.Allow, AllowTrailingCommas = true });
        while (reader.Read())
        {
            if (reader.TokenType == System.Text.Json.JsonTokenType.Comment)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The file of theoretical points.</summary>
    internal static byte[] Theoretical(IReadOnlyList<PointDraft> points)
    {
        var hasZ = points.Any(p => !string.IsNullOrWhiteSpace(p.Z));
        var text = new StringBuilder(hasZ ? "point,x_mm,y_mm,z_mm\n" : "point,x_mm,y_mm\n");
        foreach (var point in points)
        {
            text.Append(Cell(point.Label.Trim())).Append(',').Append(Coordinate(point.X)).Append(',').Append(Coordinate(point.Y));
            text.Append(hasZ ? "," + Coordinate(point.Z) : "").Append('\n');
        }

        return Encoding.UTF8.GetBytes(text.ToString());
    }

    // Text that is not a number stays as typed; the reader reports it.
    private static string Coordinate(string text) => DraftNumber.Json(text) ?? Cell(text.Trim());

    private static string Cell(string text) =>
        text.AsSpan().IndexOfAny(",\"\r\n") >= 0 ? "\"" + text.Replace("\"", "\"\"", StringComparison.Ordinal) + "\"" : text;
}
