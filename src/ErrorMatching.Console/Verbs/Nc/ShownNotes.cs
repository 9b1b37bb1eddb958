using System.Text.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>Notes on how programs were read, in every answer about a program.</summary>
internal static class ShownNotes
{
    /// <summary>Writes them as the array <c>notes</c>.</summary>
    public static void Write(Utf8JsonWriter json, params ReadOnlySpan<(string File, NcPath Path)> programs)
    {
        json.WriteStartArray("notes");
        foreach (var (file, path) in programs)
        {
            foreach (var note in NotesOf(path))
            {
                json.WriteStartObject();
                json.WriteString("file", file);
                json.WriteString("code", note.Code);
                json.WriteNumber("count", note.Count);
                json.WriteNumber("line", note.Block + 1);
                json.WriteString("block", path.Program.NumberOf(path.Program[note.Block]));
                json.WriteString("message", note.Message);
                json.WriteEndObject();
            }
        }

        json.WriteEndArray();
    }

    // What the control refuses stops the program, so it is said with every result.
    private static IEnumerable<NcNote> NotesOf(NcPath path)
    {
        NcProblem[] refused = [.. path.Problems.Where(p => p.Code == NcRefusalCodes.RefusedByControl)];
        return refused.Length == 0 ? path.Notes
            : [new(NcRefusalCodes.RefusedByControl, refused[0].Block, refused.DistinctBy(p => p.Block).Count(),
                $"The program stops at {path.Program.NameOf(path.Program[refused[0].Block])}. {refused[0].Message}"), .. path.Notes];
    }

    /// <summary>Writes them as lines.</summary>
    public static void Write(Page page, params ReadOnlySpan<(string File, NcPath Path)> programs)
    {
        foreach (var (file, path) in programs)
        {
            foreach (var note in NotesOf(path))
            {
                page.Line($"Note: {(programs.Length > 1 ? file + ": " : "")}{note.Message}");
            }
        }
    }
}
