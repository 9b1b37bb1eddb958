using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>The files that a job names, and whether they exist.</summary>
/// <param name="files">The role of each file in the job, and its path from the current folder.</param>
internal sealed class NamedFiles(IEnumerable<(string Role, string File)> files)
{
    /// <summary>Writes the member <c>files</c> to the current object.</summary>
    public void WriteJson(Utf8JsonWriter json)
    {
        json.WriteStartArray("files");
        foreach (var (role, file) in files)
        {
            json.WriteStartObject();
            json.WriteString("role", role);
            json.WriteString("file", file);
            json.WriteBoolean("exists", File.Exists(file));
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    /// <summary>Writes a table for people.</summary>
    public void WriteText(Page page) => page.Table(
        ["file", "", ""], files.Select(f => (IReadOnlyList<string>)[f.Role, f.File, File.Exists(f.File) ? "" : "not there yet"]));
}
