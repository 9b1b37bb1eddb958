using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Writes drafts as the files of a job, and reads them back without loss.</summary>
public static class MatingDraftFiles
{
    private static readonly string[] Columns = ["point", "x_mm", "y_mm", "z_mm"];

    /// <summary>The job's file.</summary>
    public static byte[] Job(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        return DraftWriter.Job(draft);
    }

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
    /// <exception cref="DraftException">The theoretical points have columns that a draft cannot represent and would lose.</exception>
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
    /// <exception cref="DraftException">The theoretical points have columns that a draft cannot represent and would lose.</exception>
    public static MatingDraft Read(ReadOnlySpan<byte> bytes, string file, ReadOnlyMemory<byte> theoretical)
    {
        var end = theoretical.Span.IndexOfAny((byte)'\r', (byte)'\n');
        var header = Encoding.UTF8.GetString(theoretical.Span[..(end < 0 ? theoretical.Length : end)]).TrimStart('\uFEFF');
        var root = JsonInput.Read(bytes, file);
        var points = MeasurementReader.Read(theoretical, root["part"]["theoretical"].Text, MeasurementFormat.Points);
        return MatingDraft.Read(root, PointsOf(points, header, file));
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

    private static PointDraft[] PointsOf(MeasurementFile theoretical, string header, string file)
    {
        var (x, y, z) = (theoretical.ColumnTexts("x_mm"), theoretical.ColumnTexts("y_mm"), theoretical.ColumnTexts("z_mm"));
        return x is not null
            && y is not null
            && x.Count == theoretical.Points.Count
            && header.Split(',').All(c => Columns.Contains(c.Trim(), StringComparer.OrdinalIgnoreCase))
            ? [.. theoretical.Points.Select((p, i) => new PointDraft(p.Label, x[i].Trim(), y[i].Trim(), z?[i].Trim() ?? ""))]
            : throw new DraftException(file, DraftPaths.Theoretical, $"a file with other columns than {string.Join(", ", Columns)}");
    }

    // Text that is not a number stays as typed; the reader reports it.
    private static string Coordinate(string text) => DraftNumber.Json(text) ?? Cell(text.Trim());

    private static string Cell(string text) =>
        text.AsSpan().IndexOfAny(",\"\r\n") >= 0 ? "\"" + text.Replace("\"", "\"\"", StringComparison.Ordinal) + "\"" : text;
}
