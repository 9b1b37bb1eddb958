namespace ErrorMatching.Freeform;

/// <summary>Finds the name of an IGES entity: its name property (406, form 15), or its label.</summary>
internal static class IgesName
{
    private const int MaxProperties = 1000;

    /// <summary>Returns the name; empty if there is none.</summary>
    public static string Of(IgesFile file, IgesEntity entity)
    {
        var parameters = file.ParametersOf(entity);
        if (!SkipOwn(entity, parameters) || parameters.Left == 0)
        {
            return entity.Label;
        }

        var notes = parameters.Int("the number of associated entities", 0, MaxProperties);
        for (var i = 0; i < notes; i++)
        {
            parameters.Int("an associated entity");
        }

        var properties = parameters.Left == 0 ? 0 : parameters.Int("the number of properties", 0, MaxProperties);
        var pointers = new int[properties];
        for (var i = 0; i < properties; i++)
        {
            pointers[i] = parameters.Int("a property");
        }

        foreach (var pointer in pointers)
        {
            var property = file.At(pointer, entity, "a property");
            if (property is { Type: 406, Form: 15 })
            {
                var own = file.ParametersOf(property);
                own.Int("the number of properties");
                return own.Text("the name").Trim();
            }
        }

        return entity.Label;
    }

    // Properties follow the type's own parameters, whose number must be known.
    private static bool SkipOwn(IgesEntity entity, IgesParameters parameters)
    {
        var count = 0L;
        switch (entity.Type)
        {
            case 128:
                var (k1, k2) = (parameters.Int("K1"), (long)parameters.Int("K2"));
                var (m1, m2) = (parameters.Int("M1"), parameters.Int("M2"));
                count = 5 + (k1 + m1 + 2L) + (k2 + m2 + 2) + (4 * (k1 + 1) * (k2 + 1)) + 4;
                break;
            case 144:
                parameters.Int("the surface");
                parameters.Int("N1");
                count = parameters.Int("N2") + 1L;
                break;
            case 143:
                parameters.Int("the kind");
                parameters.Int("the surface");
                count = parameters.Int("the number of boundaries");
                break;
            case 120:
                count = 4;
                break;
            case 122:
                count = 4;
                break;
            default:
                return false;
        }

        return parameters.Skip(count);
    }
}
