using System.Text;

namespace ErrorMatching.Nc;

/// <summary>The values of enumerations by their names as files spell them:
/// <c>WorkOffset</c> is <c>work-offset</c>, <c>PlaneXY</c> is <c>plane-xy</c>.</summary>
internal static class KebabNames
{
    /// <summary>The values of an enumeration of bytes by name. Plain numbers, since the runtime has such tables compiled already:
    /// it is on the way of every start.</summary>
    public static Dictionary<string, int> Of(Type enumeration)
    {
        var (names, values) = (enumeration.GetEnumNames(), (byte[])enumeration.GetEnumValuesAsUnderlyingType());
        var table = new Dictionary<string, int>(names.Length, StringComparer.Ordinal);
        for (var i = 0; i < names.Length; i++)
        {
            table.Add(Of(names[i]), values[i]);
        }

        return table;
    }

    /// <summary>A name as files spell it.</summary>
    public static string Of(string name)
    {
        var text = new StringBuilder(name.Length + 8);
        for (var i = 0; i < name.Length; i++)
        {
            if (i > 0 && char.IsAsciiLetterUpper(name[i]) && !char.IsAsciiLetterUpper(name[i - 1]))
            {
                text.Append('-');
            }

            text.Append(char.ToLowerInvariant(name[i]));
        }

        return text.ToString();
    }
}
