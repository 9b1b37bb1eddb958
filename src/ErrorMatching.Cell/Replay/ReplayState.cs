using System.Globalization;
using System.Text;
using System.Text.Json;

namespace ErrorMatching.Cell;

/// <summary>The state of a replay as a text, for a checkpoint. It leaves out corrections from which no step leads on: nobody may send
/// those.</summary>
internal static class ReplayState
{
    // A build that judges entries differently must not go on from what another one judged.
    private static readonly string Build = typeof(ReplayState).Module.ModuleVersionId.ToString("D", CultureInfo.InvariantCulture);

    /// <summary>Writes the state of a replay; two replays of the same entries give the same text.</summary>
    public static string Write(AuditReplay replay)
    {
        using var bytes = new MemoryStream();
        using (var json = new Utf8JsonWriter(bytes))
        {
            json.WriteStartObject();
            json.WriteString("build", Build);
            json.WriteNumber("highest", replay.Highest);
            json.WriteStartArray("corrections");
            foreach (var (id, c) in replay.Unsettled.OrderBy(c => c.Key)) Write(json, id, c, replay.CodeOf(CorrectionRow.NameOf(id)));
            json.WriteEndArray();
            json.WriteStartArray("codes");
            foreach (var row in replay.CodedRows.Where(r => !CorrectionRow.IsName(r)).Order(StringComparer.Ordinal))
                Write(json, row, replay.CodeOf(row));
            json.WriteEndArray();
            json.WriteStartArray("slots");
            foreach (var (row, id) in replay.LastInSlot.OrderBy(s => s.Key, StringComparer.Ordinal)) Write(json, row, id);
            json.WriteEndArray();
            json.WriteStartArray("people");
            foreach (var (_, person) in replay.People.OrderBy(p => p.Key, StringComparer.Ordinal)) Write(json, person);
            json.WriteEndArray();
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(bytes.GetBuffer().AsSpan(0, (int)bytes.Length));
    }

    /// <summary>True if this build wrote a state that has this key's code.</summary>
    public static bool IsOfThisBuild(string state)
    {
        using var document = JsonDocument.Parse(state);
        return document.RootElement.GetProperty("build").GetString() == Build;
    }

    /// <summary>Puts a state that this build wrote into an empty replay.</summary>
    public static void Read(string state, AuditReplay into)
    {
        using var document = JsonDocument.Parse(state);
        var root = document.RootElement;
        foreach (var c in root.GetProperty("corrections").EnumerateArray())
        {
            var correction = new RecordedCorrection(c[1].GetString()!)
            {
                State = CorrectionRow.StateOrNull(c[2].GetString()!)!.Value,
                Program = c[3].GetString(),
                Seq = c[4].GetInt64(),
                Fault = c[7].GetString() is { } fault
                    ? new AuditFault(AuditFaultKind.NotAllowed, c[8].GetInt64(), Recorded.Read(fault)) : null,
            };
            into.Restore(c[0].GetInt64(), correction);
            if (c[5].GetString() is { } code) into.Restore(CorrectionRow.NameOf(c[0].GetInt64()), code, c[6].GetInt64());
        }

        foreach (var c in root.GetProperty("codes").EnumerateArray()) into.Restore(c[0].GetString()!, c[1].GetString()!, c[2].GetInt64());
        foreach (var p in root.GetProperty("people").EnumerateArray())
        {
            var role = Rights.RoleOf(p[1].GetString()!)!.Value;
            into.Restore(new RecordedPerson(p[0].GetString()!, role, p[2].GetBoolean(), p[3].GetInt64()));
        }

        into.Restore(
            root.GetProperty("highest").GetInt64(),
            root.GetProperty("slots").EnumerateArray().Select(s => (s[0].GetString()!, s[1].GetInt64())));
    }

    private static void Write(Utf8JsonWriter json, long id, RecordedCorrection c, (string Code, long Seq)? code)
    {
        json.WriteStartArray();
        json.WriteNumberValue(id);
        json.WriteStringValue(c.File);
        json.WriteStringValue(CorrectionRow.Word(c.State));
        json.WriteStringValue(c.Program);
        json.WriteNumberValue(c.Seq);
        json.WriteStringValue(code?.Code);
        json.WriteNumberValue(code?.Seq ?? 0);
        json.WriteStringValue(c.Fault?.Statement.Text);
        json.WriteNumberValue(c.Fault?.Seq ?? 0);
        json.WriteEndArray();
    }

    private static void Write(Utf8JsonWriter json, string row, (string Code, long Seq)? code)
    {
        json.WriteStartArray();
        json.WriteStringValue(row);
        json.WriteStringValue(code?.Code);
        json.WriteNumberValue(code?.Seq ?? 0);
        json.WriteEndArray();
    }

    private static void Write(Utf8JsonWriter json, string row, long id)
    {
        json.WriteStartArray();
        json.WriteStringValue(row);
        json.WriteNumberValue(id);
        json.WriteEndArray();
    }

    private static void Write(Utf8JsonWriter json, RecordedPerson person)
    {
        json.WriteStartArray();
        json.WriteStringValue(person.Name);
        json.WriteStringValue(Rights.Word(person.Role));
        json.WriteBooleanValue(person.IsDisabled);
        json.WriteNumberValue(person.Seq);
        json.WriteEndArray();
    }
}
