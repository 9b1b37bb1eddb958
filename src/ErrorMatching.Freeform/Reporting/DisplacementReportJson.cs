using System.Text.Encodings.Web;
using System.Text.Json;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Writes the report of a displaced finishing program as JSON.</summary>
public static class DisplacementReportJson
{
    // File names are not escaped: the document is UTF-8 and is not embedded in a web page.
    private static readonly JsonWriterOptions Options = new()
    {
        Indented = true,
        NewLine = "\n",
        Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping
    };

    /// <summary>The document <c>errormatch/surface-displace/1</c>: UTF-8 without a byte order mark, ending with a newline.</summary>
    public static byte[] Write(DisplacementReport report)
    {
        using var stream = new MemoryStream();
        using (var json = new Utf8JsonWriter(stream, Options))
        {
            json.WriteStartObject();
            json.WriteString("schema", "errormatch/surface-displace/1");
            Write(json, report);
            json.WriteEndObject();
        }

        stream.WriteByte((byte)'\n');
        return stream.ToArray();
    }

    private static void Write(Utf8JsonWriter json, DisplacementReport report)
    {
        var displaced = report.Displaced;
        json.WriteString("job", report.Job.Name);
        json.WriteString("program", report.ProgramFile);
        json.WriteString("file", report.Folder is null ? null : report.File);
        json.WriteNumber("onSurface", displaced.OnSurface);
        json.WriteNumber("followed", displaced.Followed);
        json.WriteNumber("largestMoveMm", displaced.LargestMoveMm);
        json.WriteNumber("largestMisfitMm", displaced.LargestMisfitMm);
        json.WriteNumber("changedBlocks", displaced.Rewrite.ChangedBlocks.Count);
        json.WriteNumber("changedWords", displaced.Rewrite.ChangedWords);
        json.WriteStartObject("proof");
        json.WriteBoolean("holds", displaced.Proof.Holds);
        json.WriteNumber("motions", displaced.Proof.Motions);
        json.WriteNumber("movedMotions", displaced.Proof.MovedMotions);
        json.WriteString("marker", displaced.Proof.Marker);
        json.WriteNumber("maxDeviationFromWantedMm", displaced.Proof.MaxDeviationFromWantedMm);
        json.WriteBoolean("untouchedBytesIdentical", displaced.Proof.UntouchedBytesIdentical);
        json.WriteEndObject();
        CompensationReportJson.WriteCutBy(new ReportWriter(json), report.CutBy);
        CompensationReportJson.WriteResult(new ReportWriter(json), report.Compensation);
        Texts(json, "warnings", report.Compensation.Warnings);
        Texts(json, "notes", report.Compensation.Notes);
    }

    private static void Texts(Utf8JsonWriter json, string name, IReadOnlyList<string> texts)
    {
        json.WriteStartArray(name);
        foreach (var text in texts)
        {
            json.WriteStringValue(text);
        }

        json.WriteEndArray();
    }
}
