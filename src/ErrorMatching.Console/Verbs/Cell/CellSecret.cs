using System.CommandLine;
using System.Text.Json;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell secret</c>.</summary>
internal sealed class CellSecret : SigningVerb
{
    private readonly Argument<string> _machine = new("MACHINE") { Description = "The machine, as the configuration names it." };
    private readonly Option<bool> _remove = new("--remove")
    {
        Description = "Remove the password instead of setting one.",
        Arity = ArgumentArity.Zero
    };

    public CellSecret()
        : base(
            "secret",
            "Sets the password that the cell signs in to a machine with, encrypted. An administrator signs.",
            "errormatch cell secret samples/cell/cell.json vmc1 --user anna",
            "the password of who signs, then the machine's")
    {
        Arguments.Add(_machine);
        Options.Add(_remove);
    }

    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        var machine = arguments.GetRequiredValue(_machine);
        var isRemoved = arguments.GetValue(_remove);
        return !isRemoved && settings.Machines.All(m => m.Name != machine)
            ? FailureOfCell.UnknownMachine(settings, machine)
            : WithExistingStore(settings, store =>
            {
                var users = new UserBook(store, TimeProvider.System);
                var secrets = new MachineSecrets(store, settings.KeysFolder);
                var by = Sign(users, arguments);
                users.Demand(by, Act.ManageMachines);
                if (isRemoved)
                {
                    return new CellSecretAnswer(machine, isSet: false, secrets.Remove(machine, by.Name));
                }

                secrets.Set(machine, AskNew($"password at {machine}", arguments), by.Name);
                return new CellSecretAnswer(machine, isSet: true, isChanged: true);
            });
    }
}

/// <summary>The result of setting or removing a machine's password.</summary>
internal sealed class CellSecretAnswer(string machine, bool isSet, bool isChanged) : DocumentAnswer
{
    public override string Schema => "errormatch/cell-secret/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("machine", machine);
        json.WriteBoolean("isSet", isSet);
        json.WriteBoolean("isChanged", isChanged);
    }

    public override void WriteText(Page page) => page.Line(
        isSet
            ? $"The cell signs in to {machine} with the new password from now on."
            : isChanged
            ? $"The password of {machine} is removed."
            : $"{machine} had no password.");
}
