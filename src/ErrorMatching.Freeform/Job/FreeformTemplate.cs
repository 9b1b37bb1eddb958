using System.Text;

namespace ErrorMatching.Freeform;

/// <summary>Texts that help to write a free-form job.</summary>
public static class FreeformTemplate
{
    /// <summary>A commented job to start from. It passes the check, and runs beside files with the names it mentions.</summary>
    public static string Text { get; } = Resource("freeform.template.json");

    /// <summary>The JSON Schema (draft 2020-12) that jobs are checked against, with descriptions and examples for editors.</summary>
    public static string Schema { get; } = Resource("freeform.schema.json");

    private static string Resource(string name)
    {
        using var stream = typeof(FreeformTemplate).Assembly.GetManifestResourceStream(name)!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd();
    }
}
