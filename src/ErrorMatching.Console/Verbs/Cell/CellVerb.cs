using System.CommandLine;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary>A verb about a cell. Only running it loads the cell's library, which a match does not need.</summary>
internal abstract class CellVerb : Verb
{
    private readonly Argument<string> _config = new("CONFIG") { Description = "The cell's configuration." };

    /// <summary>A verb whose first argument is the configuration.</summary>
    protected CellVerb(string name, string description, string example)
        : base(name, description, example) => Arguments.Add(_config);

    public sealed override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        try
        {
            return Run(InputFile.Open(arguments.GetRequiredValue(_config), CellSettingsReader.Read), arguments, cancellation);
        }
        catch (PeopleException e)
        {
            return FailureOfCell.People(e);
        }
        catch (StoreException e)
        {
            return FailureOfCell.Store(e);
        }
        catch (DecisionException e)
        {
            return FailureOfCell.Decision(e);
        }
        catch (TransportException e)
        {
            return FailureOfCell.Machine(e);
        }
        catch (SecretInputException e)
        {
            return FailureOfCell.Secret(e);
        }
    }

    /// <summary>Does the work for a cell.</summary>
    protected abstract VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation);

    /// <summary>Works with the cell's store, which is created if it does not exist. Every entry of the audit trail is sealed with the
    /// cell's key.</summary>
    protected static VerbResult WithStore(CellSettings settings, Func<CellStore, VerbResult> work)
    {
        using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.OpenFor(settings), inspect: false);

        // Nothing is added to a store that was rolled back: its trail would get two ends.
        if (new AuditTrail(store, settings).EndFault() is { } fault)
        {
            return FailureOfCell.Audit(fault);
        }

        return Remembered(settings, store, work);
    }

    /// <summary>Reads the cell's store, which must exist and may be on a read-only disk.</summary>
    protected static VerbResult WithStoreToRead(CellSettings settings, Func<CellStore, VerbResult> work)
    {
        DemandStore(settings);
        using var store = CellStore.OpenToRead(settings.Store, TimeProvider.System, AuditKey.Find(settings.KeysFolder));
        return Remembered(settings, store, work);
    }

    private static VerbResult Remembered(CellSettings settings, CellStore store, Func<CellStore, VerbResult> work)
    {
        var outcome = work(store);
        try
        {
            new AuditTrail(store, settings).Remember();
        }
        catch (Exception e) when (e is PeopleException or StoreException)
        {
            // The requested work is done, so its answer is returned; the running cell remembers the end too, and reports if it cannot.
        }

        return outcome;
    }

    /// <summary>Works with the cell's store, which must exist.</summary>
    protected static VerbResult WithExistingStore(CellSettings settings, Func<CellStore, VerbResult> work)
    {
        DemandStore(settings);
        return WithStore(settings, work);
    }

    /// <summary>Ensures that the store exists: reading must not create an empty one, which would look right.</summary>
    protected static void DemandStore(CellSettings settings)
    {
        if (settings.Store is SqliteSettings { File: var file } && !File.Exists(file))
        {
            throw new StoreException(
                StoreError.Missing,
                $"The store {file} is not there yet. errormatch user add {settings.File} NAME --role administrator makes it, with its "
                    + $"first user.");
        }
    }
}
