using System.Globalization;
using System.Text.Json;

namespace ErrorMatching.Cell;

/// <summary>A step of a correction as it is published to the plant.</summary>
/// <param name="Entry">The audit entry that recorded it. Its hash is the identity of the message.</param>
/// <param name="From">The state before; null for an arrival.</param>
/// <param name="To">The state after.</param>
/// <param name="ProgramSha256">The program that the entry names; null if it names none.</param>
/// <param name="Correction">The correction as it is now, possibly some steps later.</param>
internal sealed record StepEvent(
    AuditEntry Entry, CorrectionState? From, CorrectionState To, string? ProgramSha256, Correction Correction)
{
    /// <summary>The schema of the message.</summary>
    public const string Schema = "errormatch/step/1";

    /// <summary>The message as JSON. It is the same whenever it is made: it has what the entry says, and of the correction what no later
    /// step changes.</summary>
    /// <remarks>It contains no names of people and no sentences: reasons may quote anything.</remarks>
    /// <param name="cell">The cell's name.</param>
    public byte[] Message(string cell)
    {
        using var bytes = new MemoryStream();
        using (var json = new Utf8JsonWriter(bytes))
        {
            json.WriteStartObject();
            json.WriteString("schema", Schema);
            json.WriteString("id", Entry.Hash);
            json.WriteNumber("entry", Entry.Seq);
            json.WriteString("at", Time(Entry.At));
            json.WriteString("cell", cell);
            json.WriteNumber("correction", Correction.Id);
            Write(json, "from", From is { } from ? CorrectionRow.Word(from) : null);
            json.WriteString("to", CorrectionRow.Word(To));
            json.WriteString("by", Entry.Who == AuditEntry.ByCell ? "cell" : "person");
            Write(json, "code", IsAsLeft ? Correction.Code : null);
            WriteCorrection(json);
            json.WriteEndObject();
        }

        return bytes.ToArray();
    }

    // Before it is recognized, it is nobody's, unless it recalculates an earlier one.
    private bool IsRecognized => To != CorrectionState.Archived || Correction.MeasuredAs is not null;

    // A code belongs to a state. A failed correction that somebody has approved again meanwhile has lost it.
    private bool IsAsLeft => Correction.State == To && Correction.ChangedAt == Entry.At;

    private void WriteCorrection(Utf8JsonWriter json)
    {
        json.WriteString("gauge", Correction.Gauge);
        json.WriteString("file", Correction.FileName);
        json.WriteString("arrivedAt", Time(Correction.ArrivedAt));
        json.WriteString("measurementSha256", Correction.MeasurementSha256);
        if (IsRecognized)
        {
            Write(json, "job", Correction.Job);
            Write(json, "piece", Correction.Piece);
            Write(json, "serial", Correction.Serial);
            Write(json, "workOrder", Correction.WorkOrder);
            Write(json, "machine", Correction.Machine);
            Write(json, "slot", Correction.Slot);
            Write(json, "program", Correction.Program);
        }

        if (To != CorrectionState.Archived)
        {
            Write(json, "jobSha256", Correction.JobSha256);
            Write(json, "baseSha256", Correction.BaseSha256);
        }

        Write(json, "programSha256", ProgramSha256);
        Write(json, "undoSha256", ProgramSha256 is null ? null : Correction.UndoSha256);
    }

    private static void Write(Utf8JsonWriter json, string name, string? text)
    {
        if (text is not null)
        {
            json.WriteString(name, text);
        }
    }

    private static string Time(DateTimeOffset time) =>
        time.UtcDateTime.ToString("yyyy-MM-ddTHH:mm:ss.ffffff'Z'", CultureInfo.InvariantCulture);
}
