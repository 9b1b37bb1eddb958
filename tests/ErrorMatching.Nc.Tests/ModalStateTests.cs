using System.Globalization;
using System.Reflection;
using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

public class ModalStateTests
{
    public static TheoryData<string> Fields => [.. typeof(ModalState).GetFields().Where(f => !f.IsStatic).Select(f => f.Name)];

    [Theory]
    [MemberData(nameof(Fields))]
    public void Two_states_are_the_same_only_if_each_field_is(string name)
    {
        var field = typeof(ModalState).GetField(name)!;
        object other = ModalState.Initial;
        field.SetValue(other, Another(field, other));

        Assert.True(ModalState.Initial.SameAs(ModalState.Initial));
        Assert.False(ModalState.Initial.SameAs((ModalState)other));
    }

    private static object Another(FieldInfo field, object state) => field.GetValue(state) switch
    {
        bool value => !value,
        int value => value + 1,
        ulong value => value + 1,
        double value => value + 1,
        ArcPole value => value with { IsKnown = !value.IsKnown },
        Point3 value => new Point3(value.X, value.Y, value.Z + 1),
        Enum value => Enum.GetValues(field.FieldType)
            .Cast<Enum>()
            .First(v => Convert.ToInt64(v, CultureInfo.InvariantCulture) != Convert.ToInt64(value, CultureInfo.InvariantCulture)),
        var value => throw new InvalidOperationException($"{field.Name} is {value}: say here what differs from it."),
    };
}
