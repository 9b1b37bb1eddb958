using System.Text.Encodings.Web;
using System.Text.Json;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>Storage of the users' preferences: one small file per user. Others may have changed or damaged it.</summary>
/// <param name="folder">The folder. It is created with the first file.</param>
public sealed class PreferenceFiles(string folder)
{
    /// <summary>Number of recently used folders that are stored.</summary>
    public const int MostFolders = 5;

    private const int MostBytes = 64 * 1024;
    private static readonly JsonWriterOptions Written = new() { Indented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };
    private static readonly Lazy<JsonSchema> Schema = new(() => JsonSchema.Parse(
        """
        {
          "type": "object",
          "required": ["user", "language", "theme", "targets", "folders"],
          "additionalProperties": false,
          "properties": {
            "user": { "type": "string" },
            "language": { "enum": ["English", "TraditionalChinese"] },
            "theme": { "enum": ["light", "dark"] },
            "targets": { "enum": ["Standard", "Large", "Largest"] },
            "keyboard": { "enum": ["Finger", "Always", "Never"] },
            "folders": { "type": "array", "maxItems": 5, "items": { "type": "string", "minLength": 1 } }
          }
        }
        """u8,
        "preferences.schema.json"));

    /// <summary>The file of a user. User names may have any characters; file names may not.</summary>
    public string Of(string user) =>
        Path.Combine(folder, $"station-{ContentHash.Sha256OfText(user)[..16]}.json");

    /// <summary>The preferences of a user; null if none are stored.</summary>
    /// <exception cref="InputException">The file cannot be read. It does not have the form that <see cref="Keep"/>
    /// writes.</exception>
    public Preferences? Read(string user)
    {
        var file = Of(user);
        if (!File.Exists(file))
        {
            return null;
        }

        var limits = JsonLimits.Default with { MaxBytes = MostBytes };
        var document = JsonInput.Read(InputFile.Open(file, f => JsonInput.Load(f, limits)), file, limits);
        return Schema.Value.Check(document) is { Count: > 0 } problems
            ? throw new InputException(file, problems)
            : new(
                Enum.Parse<Language>(document["language"].Text),
                document["theme"].Text == "dark",
                Enum.Parse<TouchSize>(document["targets"].Text),

                // Files of earlier versions do not have it.
                document.Find("keyboard") is { } keyboard ? Enum.Parse<KeyboardUse>(keyboard.Text) : Preferences.UsualKeyboard,
                [.. document["folders"].Items.Select(i => i.Text).Where(IsFolder)]);
    }

    /// <summary>Stores the preferences of a user.</summary>
    /// <exception cref="OutputException">It cannot be written.</exception>
    public void Keep(string user, Preferences preferences)
    {
        ArgumentNullException.ThrowIfNull(preferences);
        using var bytes = new MemoryStream();
        using (var writer = new Utf8JsonWriter(bytes, Written))
        {
            writer.WriteStartObject();
            writer.WriteString("user", user);
            writer.WriteString("language", preferences.Language.ToString());
            writer.WriteString("theme", preferences.IsDark ? "dark" : "light");
            writer.WriteString("targets", preferences.TouchSize.ToString());
            writer.WriteString("keyboard", preferences.Keyboard.ToString());
            writer.WriteStartArray("folders");
            foreach (var kept in preferences.Folders.Take(MostFolders))
            {
                writer.WriteStringValue(kept);
            }

            writer.WriteEndArray();
            writer.WriteEndObject();
        }

        OutputFile.Write(Of(user), bytes.ToArray(), [], CancellationToken.None);
    }

    // A path that no system accepts would only be in the way.
    private static bool IsFolder(string path) => !path.Contains('\0', StringComparison.Ordinal) && Path.IsPathFullyQualified(path);
}
