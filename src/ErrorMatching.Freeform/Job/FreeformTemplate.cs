using System.Text;

namespace ErrorMatching.Freeform;

/// <summary>The template and the schema for free-form jobs.</summary>
public static class FreeformTemplate
{
    /// <summary>A commented template for jobs. It passes the check, and runs if the files that it names exist next to it.</summary>
    public static string Text { get; } = Resource("freeform.template.json");

    /// <summary>The JSON Schema (draft 2020-12) for jobs, with descriptions and examples for editors.</summary>
    public static string Schema { get; } = Resource("freeform.schema.json");

    private static string Resource(string name)
    {
        using var stream = typeof(FreeformTemplate).Assembly.GetManifestResourceStream(name)!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd();
    }
}
