using System.CommandLine;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>The option for values of variables that only the machine knows.</summary>
internal sealed class AssumeOption
{
    private readonly Option<string[]> _values = new("--assume")
    {
        Description = "The value of a variable that only the machine knows, such as #100=1, for a program that depends on it and does not "
            + "set it itself. May be given several times. The result holds for these values only.",
        HelpName = "NAME=VALUE",
    };

    public AssumeOption() => _values.Validators.Add(result =>
    {
        foreach (var token in result.Tokens.Where(t => AssumedValues.Read(t.Value) is null))
        {
            result.AddError($"--assume is {token.Value}; expected the name of a variable and its value, such as #100=1 or R5=2.5.");
        }
    });

    public Option Option => _values;

    /// <summary>What the user stated.</summary>
    public AssumedValues Of(ParseResult arguments) =>
        AssumedValues.Of((arguments.GetValue(_values) ?? []).Select(AssumedValues.Read).OfType<KeyValuePair<string, double>>());
}
