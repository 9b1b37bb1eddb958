using System.Text.Json;

namespace ErrorMatching.Console.Tests;

/// <summary>Runs a command line in this process, with strings for streams.</summary>
internal static class Shell
{
    public static (int Exit, string Output, string Error) Run(params IReadOnlyList<string> args) => Run(null, args);

    /// <summary>The same, with somebody who gives passwords.</summary>
    public static (int Exit, string Output, string Error) Run(SecretInput? secrets, IReadOnlyList<string> args)
    {
        using var output = new StringWriter { NewLine = "\n" };
        using var error = new StringWriter { NewLine = "\n" };
        var terminal = new Terminal(output, error, HasColor: false);
        var exit = Application.Run(
            args, secrets is null ? terminal : terminal with { Secrets = secrets }, TestContext.Current.CancellationToken);
        return (exit, output.ToString(), error.ToString());
    }

    /// <summary>Runs a command line with --json and demands one document of a schema, and nothing on the error stream.</summary>
    public static JsonElement Json(int exit, string schema, params IReadOnlyList<string> args)
    {
        var (actual, output, error) = Run([.. args, "--json"]);
        Assert.Equal("", error);
        using var document = JsonDocument.Parse(output);
        Assert.EndsWith("}\n", output, StringComparison.Ordinal);
        Assert.Equal(schema, document.RootElement.GetProperty("schema").GetString());
        Assert.Equal(exit, actual);
        return document.RootElement.Clone();
    }

    /// <summary>The only error of a command line that is wrong.</summary>
    public static JsonElement Error(int exit, params IReadOnlyList<string> args)
    {
        var document = Json(exit, "errormatch/error/1", args);
        Assert.Equal(exit, document.GetProperty("exit").GetInt32());
        return Assert.Single(document.GetProperty("errors").EnumerateArray());
    }

    public static double Number(this JsonElement json, string name) => json.GetProperty(name).GetDouble();

    public static string? Text(this JsonElement json, string name) => json.GetProperty(name).GetString();
}
