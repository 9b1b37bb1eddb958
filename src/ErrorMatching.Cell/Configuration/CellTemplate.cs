using System.Text;

namespace ErrorMatching.Cell;

/// <summary>A template and a schema for writing a cell's configuration.</summary>
public static class CellTemplate
{
    /// <summary>A commented configuration to start from. It conforms to the schema, and passes the check if a job with the name it mentions
    /// is next to it.</summary>
    public static string Text { get; } = Resource("cell.template.json");

    /// <summary>The JSON Schema (draft 2020-12) that configurations are checked against, with descriptions, defaults and examples for
    /// editors.</summary>
    public static string Schema { get; } = Resource("cell.schema.json");

    private static string Resource(string name)
    {
        using var stream = typeof(CellTemplate).Assembly.GetManifestResourceStream(name)!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd();
    }
}
