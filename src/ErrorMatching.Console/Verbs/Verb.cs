using System.CommandLine;
using System.Diagnostics.CodeAnalysis;
using ErrorMatching.Jobs;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>One command of the console. It turns parsed arguments into an outcome, without parsing or printing.</summary>
internal abstract class Verb : Command
{
    /// <summary>A command.</summary>
    /// <param name="name">The word on the command line.</param>
    /// <param name="description">One sentence for the help.</param>
    /// <param name="example">A whole command line that works in the root of the checkout.</param>
    protected Verb(string name, string description, string example)
        : base(name, description) => Example = example;

    /// <summary>A whole command line that works in the root of the checkout.</summary>
    public string Example { get; }

    /// <summary>What <c>-</c> names on the command line.</summary>
    public StandardInput Input { get; set; } = StandardInput.Empty;

    /// <summary>The source of passwords, for verbs that people sign.</summary>
    public SecretInput? Secrets { get; set; }

    /// <summary>The terminal for progress of long operations; null if there is none.</summary>
    public TextWriter? ProgressTo { get; set; }

    /// <summary>Runs the command.</summary>
    /// <param name="arguments">The user's arguments, parsed without errors.</param>
    /// <param name="cancellation">Set by Ctrl+C.</param>
    public abstract VerbResult Run(ParseResult arguments, CancellationToken cancellation);

    /// <summary>An option for a file.</summary>
    protected static Option<string> FileOption(string name, string description) =>
        new(name) { Description = description, HelpName = "FILE" };

    /// <summary>A program that the user named, or standard input; null for none.</summary>
    /// <exception cref="InputException">Standard input cannot be read, or is too large.</exception>
    [return: NotNullIfNotNull(nameof(file))]
    protected GivenFile? GivenProgram(string? file) =>
        file is null ? null : Input.File(file, NcProgram.MaxBytes, NcInputCodes.ProgramTooLarge);

    /// <summary>A measurement that the user named, or standard input; null for none. Its reader knows the limit of its format.</summary>
    /// <exception cref="InputException">Standard input cannot be read, or is too large.</exception>
    [return: NotNullIfNotNull(nameof(file))]
    protected GivenFile? GivenMeasurement(string? file) =>
        file is null ? null : Input.File(file, MeasurementFormat.Points.MaxBytes, MeasurementError.FileTooLarge);

    /// <summary>The columns of a table of numbers that the user named, or of standard input.</summary>
    /// <exception cref="InputException">It cannot be opened, or is no such table.</exception>
    protected NumberTable Numbers(string file, params IReadOnlyList<string> columns) => GivenMeasurement(file) is { Bytes: { } bytes } given
        ? NumberTable.Read(bytes, given.File, columns)
        : NumberTable.Read(file, columns);

    /// <summary>Rejects a value of the wrong form as a command line error.</summary>
    protected static void Demand(Option<string> option, Predicate<string> isGood, string expected) => option.Validators.Add(result =>
    {
        if (result.Tokens is [var token] && !isGood(token.Value))
        {
            result.AddError($"{option.Name} is {token.Value}; expected {expected}.");
        }
    });
}
