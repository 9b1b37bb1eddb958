using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Mating;

/// <summary>Makes refusals about features of a job.</summary>
public static class FeatureRefusal
{
    /// <summary>A program's refusal as one of a feature: the message begins with the feature's name.</summary>
    /// <param name="refusal">The refusal.</param>
    /// <param name="feature">Name of the feature concerned, or null.</param>
    public static Refusal Of(Refusal refusal, string? feature)
    {
        ArgumentNullException.ThrowIfNull(refusal);
        return feature is null
            ? refusal
            : refusal with { Message = $"{feature}: {refusal.Message}", Place = refusal.Place with { Feature = feature } };
    }

    /// <summary>A refusal at a block of a feature; the message begins with the names of both.</summary>
    internal static Refusal At(NcPath path, int block, string code, string message, string feature, string? point = null)
    {
        var name = path.Program.NameOf(path.Program[block]);
        return new(
            code,
            $"{feature}, {name}: {message}",
            new() { Block = name, Line = path.Program[block].Line, Feature = feature, Point = point });
    }
}
