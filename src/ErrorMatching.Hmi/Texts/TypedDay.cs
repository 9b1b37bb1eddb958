using System.Globalization;

namespace ErrorMatching.Hmi;

/// <summary>A day that a person types: year-month-day or year/month/day, in the computer's time zone.</summary>
internal static class TypedDay
{
    private static readonly string[] Formats = ["yyyy-MM-dd", "yyyy/MM/dd"];

    /// <summary>Reads a day.</summary>
    /// <param name="text">The text; blank for none.</param>
    /// <param name="more">Days to add: 1 for the end of the day, so that it is included.</param>
    /// <param name="clock">The clock, which knows the time zone.</param>
    /// <param name="time">The beginning of the day; null for none.</param>
    /// <returns>False if it is not a day.</returns>
    public static bool TryRead(string text, int more, TimeProvider clock, out DateTimeOffset? time)
    {
        ArgumentNullException.ThrowIfNull(clock);
        time = null;
        if (string.IsNullOrWhiteSpace(text))
        {
            return true;
        }

        if (!DateTime.TryParseExact(text.Trim(), Formats, CultureInfo.InvariantCulture, DateTimeStyles.None, out var day)
            || day.Date == DateTime.MaxValue.Date)
        {
            return false;
        }

        day = day.AddDays(more);
        time = new DateTimeOffset(day, clock.LocalTimeZone.GetUtcOffset(day));
        return true;
    }
}
