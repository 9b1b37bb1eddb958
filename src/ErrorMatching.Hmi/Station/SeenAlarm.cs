using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>An alarm of the cell, with what people did about it.</summary>
/// <param name="Alarm">The alarm.</param>
/// <param name="Outside">The pieces that it is about; null for other kinds than <see cref="AlarmKind.Outside"/>.</param>
/// <param name="Mark">Who acknowledged and who shelved it.</param>
/// <param name="IsAcknowledged">True if somebody acknowledged this occurrence.</param>
/// <param name="IsShelved">True if it is shelved now.</param>
internal sealed record SeenAlarm(Alarm Alarm, OutsidePieces? Outside, AlarmMark Mark, bool IsAcknowledged, bool IsShelved)
{
    /// <summary>All alarms, shelved ones too: the most urgent first, of those the ones that nobody acknowledged, of those the
    /// newest.</summary>
    /// <param name="station">The station.</param>
    public static IReadOnlyList<SeenAlarm> Of(Station station)
    {
        ArgumentNullException.ThrowIfNull(station);
        if (station.State.Status is not { } status)
        {
            return [];
        }

        var (state, now) = (station.State, station.Clock.GetUtcNow());
        return
        [
            .. Alarm.Of(status).Select(a => Seen(a, null))
                .Concat(OutsidePieces.Of(station.Outside).Select(o => Seen(Alarm.OfOutside(o.Newest.Counterpart!), o)))
                .OrderByDescending(a => a.Alarm.Priority)
                .ThenBy(a => a.IsAcknowledged)
                .ThenByDescending(a => a.Alarm.Since),
        ];

        SeenAlarm Seen(Alarm alarm, OutsidePieces? outside)
        {
            var mark = state.MarkOf(alarm);
            return new(alarm, outside, mark, mark.IsAcknowledged(alarm), mark.IsShelved(alarm, now));
        }
    }
}
