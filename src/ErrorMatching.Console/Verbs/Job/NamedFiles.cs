using System.Text.Json;

namespace ErrorMatching.Console;

/// <summary>The files that a job names, and whether they are there.</summary>
/// <param name="files">What each is to the job, and its path as seen from where the caller is.</param>
internal sealed class NamedFiles(IEnumerable<(string Role, string File)> files)
{
    /// <summary>The member <c>files</c>, in the object that is open.</summary>
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

    /// <summary>A table for people.</summary>
    public void WriteText(Page page) => page.Table(["file", "", ""], files.Select(f => (IReadOnlyList<string>)[f.Role, f.File, File.Exists(f.File) ? "" : "not there yet"]));
}
