using System.Text;

namespace ErrorMatching.Mating;

/// <summary>Texts that help to write a mating job.</summary>
public static class JobTemplate
{
    /// <summary>A commented job to start from. It passes the check, and runs if the files that it names are next to it.</summary>
    public static string Text { get; } = Resource("mating.template.json");

    /// <summary>The JSON Schema (draft 2020-12) that jobs are checked against, with descriptions and examples for editors.</summary>
    public static string Schema { get; } = Resource("mating.schema.json");

    private static string Resource(string name)
    {
        using var stream = typeof(JobTemplate).Assembly.GetManifestResourceStream(name)!;
        using var reader = new StreamReader(stream, Encoding.UTF8);
        return reader.ReadToEnd();
    }
}
