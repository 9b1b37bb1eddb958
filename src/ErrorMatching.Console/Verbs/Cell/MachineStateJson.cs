using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary>What a machine is doing, as JSON and as text.</summary>
internal static class MachineStateJson
{
    /// <summary>Writes the state as the member <c>machineState</c>.</summary>
    public static void Write(Utf8JsonWriter json, MachineState state)
    {
        json.WriteStartObject("machineState");
        json.WriteString("activity", Word(state));
        if (state.Programs is { } programs)
        {
            json.WriteStartArray("programs");
            foreach (var program in programs)
            {
                json.WriteStringValue(program);
            }

            json.WriteEndArray();
        }

        if (state.Since is { } since)
        {
            json.WriteString("since", CorrectionJson.Time(since));
        }

        if (state.Why is { } why)
        {
            json.WriteString("reason", why.Sentence);
            CorrectionJson.Write(json, "reasonStatement", why);
        }

        json.WriteEndObject();
    }

    /// <summary>The state with the active program.</summary>
    public static string Text(MachineState state) => state.Named is { Length: > 0 } named ? $"{Word(state)}, {named}" : Word(state);

    private static string Word(MachineState state) => state.Activity.ToString().ToLowerInvariant();
}
