using System.Globalization;
using System.Text;
using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>An audit trail as CSV, of any length: it is never completely in memory.</summary>
/// <param name="entries">The number of entries.</param>
/// <param name="sha256">The hash of its bytes.</param>
/// <param name="file">The file that it was written to; null for standard output.</param>
/// <param name="csv">Holds the CSV until it is written to standard output; null if it was written to a file.</param>
internal sealed class AuditExportAnswer(long entries, string sha256, string? file, Stream? csv) : DocumentAnswer
{
    private const int PartLength = 16 * 1024;

    public override string Schema => "errormatch/audit-export/1";

    public override void WriteJson(TextWriter output)
    {
        using var stream = new TextStream(output);
        OutcomeWriter.Json(stream, Schema, WriteJson);
    }

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteNumber("entries", entries);
        json.WriteString("sha256", sha256);
        if (csv is null)
        {
            return;
        }

        json.WritePropertyName("csv");
        foreach (var part in Parts(csv))
        {
            json.WriteStringValueSegment(part.Span, isFinalSegment: false);
            json.Flush();
        }

        json.WriteStringValueSegment(default(ReadOnlySpan<char>), isFinalSegment: true);
    }

    public override void WriteText(Page page)
    {
        if (csv is null)
        {
            page.Line(string.Create(CultureInfo.InvariantCulture, $"Wrote {entries} entries to {file}."));
            return;
        }

        foreach (var part in Parts(csv))
        {
            page.Text(part.Span);
        }
    }

    private static IEnumerable<ReadOnlyMemory<char>> Parts(Stream csv)
    {
        csv.Position = 0;
        using var reader = new StreamReader(csv, Encoding.UTF8);
        var part = new char[PartLength];
        for (int read; (read = reader.Read(part)) > 0;)
        {
            yield return part.AsMemory(0, read);
        }
    }
}
