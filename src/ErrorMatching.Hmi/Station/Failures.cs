using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>Texts for failed actions: the station's text for a known code, and the library's sentence if it says more.</summary>
public static class Failures
{
    /// <summary>True for failures from outside the program: they are shown and are not defects.</summary>
    public static bool IsKnown(Exception failure) =>
        failure is PeopleException
            or DecisionException
            or StoreException
            or TransportException
            or DuplicateCorrectionException
            or SlotTakenException
            or InputException
            or OutputException
            or JobEditException
            or IOException
            or UnauthorizedAccessException;

    /// <summary>Runs work off the UI thread.</summary>
    /// <returns>The failure in words; null if it succeeded.</returns>
    public static async Task<string?> OfAsync(Action work, TimeProvider clock)
    {
        try
        {
            await Task.Run(work);
            return null;
        }
        catch (Exception e) when (IsKnown(e))
        {
            return Of(e, clock);
        }
        catch (ObjectDisposedException e) when (e.ObjectName.StartsWith("ErrorMatching.Cell.", StringComparison.Ordinal))
        {
            // The station was closed meanwhile, and its store with it. What waits for the result ends as after any failure; nobody sees it.
            return Texts.Current.Word(StoreError.Away);
        }
    }

    /// <summary>The text for a failure.</summary>
    public static string Of(Exception failure, TimeProvider clock)
    {
        ArgumentNullException.ThrowIfNull(failure);
        var texts = Texts.Current;
        return failure switch
        {
            PeopleException { LockedUntil: { } until } => texts.With("PeopleError.LockedUntil", Shown.Time(until, clock)),
            PeopleException e => texts.Word(e.Error),
            JobEditException e => texts.Or("JobEdit." + e.Code, e.Message),
            DecisionException e => texts["Decision." + e.Code],
            StoreException e => texts.Word(e.Error),
            TransportException e => texts.Word(e.Error),
            OutputException e => CodeText.Of(e.Code, e.Message),
            _ => CodeText.Of((failure as InputException)?.Code ?? "", failure.Message),
        };
    }
}
