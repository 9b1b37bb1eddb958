using System.Globalization;
using System.Text.Json;
using ErrorMatching.Cell;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>Corrections in JSON documents.</summary>
internal static class CorrectionJson
{
    /// <summary>The name of a state.</summary>
    public static string Word(CorrectionState state) => state.ToString().ToLowerInvariant();

    /// <summary>A time: ISO 8601 in UTC, to the millisecond.</summary>
    public static string Time(DateTimeOffset time) => time.UtcDateTime.ToString("yyyy-MM-ddTHH:mm:ss.fff'Z'", CultureInfo.InvariantCulture);

    /// <summary>Writes a correction as an object.</summary>
    public static void Write(Utf8JsonWriter json, Correction correction)
    {
        json.WriteStartObject();
        WriteMembers(json, correction);
        json.WriteEndObject();
    }

    /// <summary>Writes a correction's members.</summary>
    public static void WriteMembers(Utf8JsonWriter json, Correction correction)
    {
        json.WriteNumber("id", correction.Id);
        json.WriteString("state", Word(correction.State));
        if (correction.MeasuredAs is { } first)
        {
            json.WriteNumber("measuredAs", first);
        }
        else
        {
            json.WriteNull("measuredAs");
        }

        json.WriteString("gauge", correction.Gauge);
        json.WriteString("fileName", correction.FileName);
        json.WriteString("arrivedAt", Time(correction.ArrivedAt));
        json.WriteString("changedAt", Time(correction.ChangedAt));
        json.WriteString("measurementSha256", correction.MeasurementSha256);
        json.WriteNumber("measurementBytes", correction.MeasurementBytes);
        json.WriteString("job", correction.Job);
        json.WriteString("piece", correction.Piece);
        json.WriteString("serial", correction.Serial);
        json.WriteString("workOrder", correction.WorkOrder);
        json.WriteString("machine", correction.Machine);
        json.WriteString("slot", correction.Slot);
        json.WriteString("program", correction.Program);
        json.WriteString("identity", correction.Identity);
        json.WriteString("jobSha256", correction.JobSha256);
        json.WriteString("baseSha256", correction.BaseSha256);
        json.WriteString("programSha256", correction.ProgramSha256);
        json.WriteString("previousSha256", correction.PreviousSha256);
        json.WriteString("undoSha256", correction.UndoSha256);
        json.WriteString("offset", correction.Offset?.Sentence);
        Write(json, "offsetStatement", correction.Offset);
        json.WriteNumberOrNull("largestMm", correction.LargestMm);
        json.WriteNumberOrNull("sumMm", correction.SumMm);
        json.WriteString("code", correction.Code);
        json.WriteString("reason", correction.Reason?.Sentence);
        Write(json, "reasonStatement", correction.Reason);
        json.WriteString("trace", correction.Trace);
    }

    /// <summary>Writes a statement with a code as an array, the code first; null for none and for words.</summary>
    public static void Write(Utf8JsonWriter json, string name, Statement? statement)
    {
        json.WritePropertyName(name);
        if (statement is { IsCoded: true })
        {
            Write(json, statement);
        }
        else
        {
            json.WriteNullValue();
        }
    }

    private static void Write(Utf8JsonWriter json, Statement statement)
    {
        if (statement.Words is { } words)
        {
            json.WriteStringValue(words);
            return;
        }

        json.WriteStartArray();
        json.WriteStringValue(statement.Code);
        foreach (var value in statement.Values)
        {
            Write(json, value);
        }

        json.WriteEndArray();
    }
}
