using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Json;

namespace ErrorMatching.Hmi;

/// <summary>What a person is told when something that was asked for does not work: the station's words for what is known by code, and the library's sentence where it says more.</summary>
public static class Failures
{
    /// <summary>True for what happens outside of the program, and is told and not a defect.</summary>
    public static bool IsKnown(Exception failure) =>
        failure is PeopleException or DecisionException or StoreException or TransportException or DuplicateCorrectionException or SlotTakenException or InputException or OutputException or JsonDocumentException or JobEditException or IOException or UnauthorizedAccessException;

    /// <summary>Does something beside the screen.</summary>
    /// <returns>What did not work, in words; null if it worked.</returns>
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
    }

    /// <summary>What to say.</summary>
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
            _ => CodeText.Of(ErrorItems.OfInput(failure) is [var item, ..] ? item.Code : "", failure.Message),
        };
    }
}
